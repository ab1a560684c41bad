// The page docs/benchmarks.md from what the benchmarks of one run have measured: `./run bench` calls it with their folder, in which each
// has left Google Benchmark's JSON, and renders their reports.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include <fairlight/render/film.h>

namespace {

using nlohmann::json;

json read(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw std::invalid_argument("\"" + file + "\" cannot be read (./run bench makes it)");
  return json::parse(in);
}

/// The medians of a benchmark's repetitions.
class Medians {
 public:
  explicit Medians(const std::string& file) {
    const json report = read(file);
    for (const json& entry : report.at("benchmarks")) {
      if (entry.value("aggregate_name", "") != "median") continue;
      const std::string name = entry.at("run_name");
      names_.push_back(name.substr(0, name.find("/repeats:")));
      entries_[names_.back()] = entry;
    }
  }

  /// In the order in which they were measured.
  const std::vector<std::string>& names() const { return names_; }
  bool has(const std::string& name) const { return entries_.contains(name); }
  double value(const std::string& name, const std::string& counter) const {
    if (!has(name)) throw std::invalid_argument("\"" + name + "\" was not measured (run all benchmarks)");
    return entries_.at(name).at(counter);
  }

 private:
  std::vector<std::string> names_;
  std::map<std::string, json> entries_;
};

/// Three digits, and no exponent.
std::string number(double x) {
  if (x >= 99.95) return std::to_string(std::llround(x));
  std::ostringstream out;
  out << std::setprecision(3) << std::showpoint << x;
  return out.str();
}

std::string millions(double rate) { return number(rate / 1e6); }

// A line of /proc/cpuinfo, which every Linux has; not all name their processor there.
std::string processor() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "a processor without a name";
}

std::string compiler() {
#if defined(__clang__)
  return "Clang " __clang_version__;
#else
  return "GCC " __VERSION__;
#endif
}

void print_head(const json& context) {
  std::cout << "# Benchmarks\n\n"
               "This page is written by `./run bench`, which measures the machine that it runs on. Every figure is "
               "the median of "
               "repetitions\nin one run, on one thread where none are named. Rates are those of this machine as "
               "busy as it was; what "
               "carries over to "
               "another are the ratios.\n\n"
               "| machine | |\n|---|---|\n"
            << "| processor | " << processor() << " |\n"
            << "| cores | " << context.at("num_cpus").get<int>() << " |\n"
            << "| compiler | " << compiler() << " |\n";
}

/// A table of rates in double and in packets.
void print_rates(const std::string& title, const std::string& what, const Medians& medians) {
  std::cout << "\n## " << title << "\n\n| " << what
            << " | `double` [M/s] | packet [M/s] | ratio |\n|---|--:|--:|--:|\n";
  constexpr std::string_view suffix = "/double";
  for (const std::string& name : medians.names()) {
    if (!name.ends_with(suffix)) continue;
    const std::string stem = name.substr(0, name.size() - suffix.size());
    const double one = medians.value(name, "items_per_second");
    const double many = medians.value(stem + "/packet", "items_per_second");
    std::cout << "| " << stem << " | " << millions(one) << " | " << millions(many) << " | " << number(many / one)
              << " |\n";
  }
}

void print_intersection(const Medians& medians) {
  const double peak = medians.value("fused multiply-adds", "flop");
  const std::string name = "intersect cornell-simple";
  const double useful = medians.value(name, "flop");
  std::cout << "\n## The intersector\n\n"
               "Rays against all surfaces of `cornell-simple`, and the useful floating-point operations of that, "
               "counted by hand in\n"
               "`tests/benchmarks/render_benchmark.cpp`; the peak is that of a loop of fused multiply-adds that "
               "wait for nothing.\n\n"
               "| | |\n|---|--:|\n"
            << "| rays [M/s] | " << millions(medians.value(name, "rays")) << " |\n"
            << "| useful operations [GFLOP/s] | " << number(useful / 1e9) << " |\n"
            << "| peak [GFLOP/s] | " << number(peak / 1e9) << " |\n"
            << "| share of the peak | " << number(100 * useful / peak) << " % |\n";
}

void print_scenes(const Medians& medians) {
  std::vector<std::string> scenes, kinds;
  for (const std::string& name : medians.names()) {
    const std::size_t slash = name.find('/');
    if (slash == std::string::npos) continue;
    const std::string scene = name.substr(0, slash), kind = name.substr(slash + 1);
    if (std::ranges::find(scenes, scene) == scenes.end()) scenes.push_back(scene);
    if (std::ranges::find(kinds, kind) == kinds.end()) kinds.push_back(kind);
  }
  std::cout << "\n## The path tracer\n\n"
               "Camera paths per second [M/s] of 256 x 256 pixels, 64 samples each: light by shadow rays to one "
               "luminaire, roulette by throughput\nfrom the third bounce on. In `double` and of many lights, 2 "
               "samples each; in packets by every instruction "
               "set of the machine.\n\n| scene |";
  for (const std::string& kind : kinds) std::cout << " " << kind << " |";
  std::cout << " " << kinds.back() << " / " << kinds.front() << " | rays a path |\n|---|";
  for (std::size_t i = 0; i < kinds.size() + 2; ++i) std::cout << "--:|";
  std::cout << "\n";
  for (const std::string& scene : scenes) {
    const auto paths = [&](const std::string& kind) { return medians.value(scene + "/" + kind, "paths"); };
    std::cout << "| " << scene << " |";
    for (const std::string& kind : kinds) std::cout << " " << millions(paths(kind)) << " |";
    const double rays = medians.value(scene + "/" + kinds.back(), "rays") / paths(kinds.back());
    std::cout << " " << number(paths(kinds.back()) / paths(kinds.front())) << " | " << number(rays) << " |\n";
  }
}

/// A render's strategies are its benchmark's name, with slashes between them.
void print_efficiency(const Medians& medians) {
  std::cout
      << "\n## Efficiency\n\n"
         "What a CPU second buys, 1/(MSE x seconds): `cornell-simple`, 256 x 256 pixels, 64 samples each, "
         "roulette by throughput, sets of 64\npoints. The MSE is half the mean squared difference of two seeds; "
         "left out are the three rows at the top and three pixels about\nthe light.\n\n"
         "| light sampled by | shared | numbers | CPU seconds | variance a path | efficiency |\n"
         "|---|---|---|--:|--:|--:|\n";
  for (const std::string& name : medians.names()) {
    std::string cells = name;
    for (std::size_t at; (at = cells.find('/')) != std::string::npos;) cells.replace(at, 1, " | ");
    std::cout << "| " << cells << " | " << number(medians.value(name, "seconds")) << " | "
              << number(medians.value(name, "variance")) << " | " << number(medians.value(name, "efficiency"))
              << " |\n";
  }
}

void print_core_test(const Medians& medians) {
  const auto nanoseconds = [&](const std::string& name) { return 1e9 / medians.value(name, "items_per_second"); };
  const double sum = nanoseconds("sum_the_draws"), test = nanoseconds("test_the_draws");
  std::cout << "\n## The core test\n\n"
               "What the betting test adds to a loop that sums the same draws, exponential ones of a uniform "
               "number and a logarithm.\n\n"
               "| | ns a draw |\n|---|--:|\n"
            << "| summed | " << number(sum) << " |\n| tested | " << number(test) << " |\n"
            << "| ratio | " << number(test / sum) << " |\n";
}

/// Of pairs of renders on one thread and on two, one after the other.
void print_threads(const std::vector<std::pair<json, json>>& pairs) {
  std::vector<double> ratios;
  for (const auto& [one, two] : pairs)
    ratios.push_back(one.at("seconds").get<double>() / two.at("seconds").get<double>());
  std::ranges::sort(ratios);
  std::cout << "\n## Threads\n\nHow many times as fast two threads render `cornell-simple`, 256 x 256 pixels, 512 "
               "samples each; of pairs of renders, one after the other.\n\n"
               "| pairs | least | median | most |\n|--:|--:|--:|--:|\n"
            << "| " << ratios.size() << " | " << number(ratios.front()) << " | "
            << number(ratios[ratios.size() / 2]) << " | " << number(ratios.back()) << " |\n";
}

/// Of renders that differ in their samples per pixel alone, on all threads.
void print_memory(const std::vector<json>& renders) {
  constexpr double mebi = 1024 * 1024;
  constexpr std::size_t a_pixel = sizeof(fairlight::Film::Pixel);
  std::cout
      << "\n## Memory\n\nThe film holds the exact moments of three channels, " << a_pixel
      << " bytes a pixel. The rest does not grow with the samples. On all threads.\n\n"
         "| picture | samples a pixel | film [MiB] | peak [MiB] | above the film [MiB] |\n|---|--:|--:|--:|--:|\n";
  for (const json& render : renders) {
    const double width = render.at("settings").at("width"), height = render.at("settings").at("height");
    const double film = width * height * static_cast<double>(a_pixel);
    const double peak = render.at("peak_bytes");
    std::cout << "| " << render.at("scene").get<std::string>() << ", " << width << " x " << height << " | "
              << number(render.at("paths").get<double>() / (width * height)) << " | " << number(film / mebi)
              << " | " << number(peak / mebi) << " | " << number((peak - film) / mebi) << " |\n";
  }
}

void print_page(const std::string& folder) {
  print_head(read(folder + "/sampler.json").at("context"));
  print_rates("Samplers", "draws of", Medians(folder + "/sampler.json"));
  print_rates("Lights", "draws of", Medians(folder + "/light.json"));
  print_rates("Surfaces", "bounces off", Medians(folder + "/bsdf.json"));
  const Medians render(folder + "/render.json");
  print_intersection(render);
  print_scenes(render);
  print_efficiency(Medians(folder + "/efficiency.json"));
  print_core_test(Medians(folder + "/betting.json"));
  std::vector<std::pair<json, json>> pairs;
  for (const char pair : {'1', '2', '3', '4', '5'})
    pairs.emplace_back(read(folder + "/threads_1_" + pair + ".json"),
                       read(folder + "/threads_2_" + pair + ".json"));
  print_threads(pairs);
  print_memory(
      {read(folder + "/memory_1.json"), read(folder + "/memory_4.json"), read(folder + "/memory_16.json")});
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 2) throw std::invalid_argument("one argument is needed (the folder of what was measured)");
    print_page(argv[1]);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "benchmarks_page: " << error.what() << "\n";
    return 2;
  }
}
