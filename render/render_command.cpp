#include <chrono>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>

#include <sys/resource.h>

#include <fairlight/render/contact_sheet.h>
#include <fairlight/render/file_lock.h>
#include <fairlight/render/instruction_sets.h>
#include <fairlight/render/parallel.h>
#include <fairlight/render/picture.h>
#include <fairlight/render/progress.h>
#include <fairlight/render/render_command.h>
#include <fairlight/render/render_image.h>
#include <fairlight/render/whole_file.h>
#include <fairlight/stats/seed.h>

namespace fairlight {
namespace {

constexpr std::uint64_t most_samples = 0xFFFFFFFF;  // of a pixel: the EXR's layer counts in 32 bits
constexpr unsigned long most_shards = 65536;
constexpr std::uint32_t usual_points = 16;

struct RenderOptions {
  RenderSettings settings;
  std::uint64_t spp = 0;
  std::uint32_t points = 0;  ///< 0 if not given
  std::string output, png, json, seed, resume, instructions;
  std::string shard = "1/1";
  int threads = hardware_threads();
};

// Shard i of N holds sets (i-1) sets / N to i sets / N, of so many points each.
SampleRange shard_range(const std::string& shard, std::uint64_t first, std::uint64_t sets, std::uint64_t points) {
  unsigned long i = 0;
  unsigned long n = 0;
  char rest = 0;
  if (std::sscanf(shard.c_str(), "%lu/%lu%c", &i, &n, &rest) != 2 || i < 1 || i > n || n > most_shards) {
    throw std::invalid_argument("\"" + shard +
                                "\" is not a shard (give i/N with i from 1 to N, and N at most 65536)");
  }
  if (i * sets / n * points > std::numeric_limits<std::uint64_t>::max() - first)
    throw std::invalid_argument("the samples of this seed have run out (there are 2^64; give another --seed)");
  const SampleRange range{first + (i - 1) * sets / n * points, first + i * sets / n * points};
  if (range.first == range.last)
    throw std::invalid_argument("shard " + shard + " is empty (there are more shards than " +
                                (points == 1 ? "samples)" : "sets of points)"));
  return range;
}

Picture start(const RenderOptions& options) {
  if (options.resume.empty()) return {options.settings, {}, Film(options.settings.width, options.settings.height)};
  Picture picture = read_exr(options.resume);
  Picture empty{options.settings, {}, Film(picture.film.width(), picture.film.height())};
  empty.merge(picture);  // refuses a picture of something else
  return empty;
}

std::uint64_t choose_seed(const RenderOptions& options, const Picture& picture) {
  if (!options.seed.empty()) return parse_seed(options.seed);
  return options.resume.empty() ? fresh_seed() : picture.samples.seed();
}

long peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss * 1024;
}

nlohmann::json report(const RenderOptions& options, std::uint64_t seed, const RenderCost& cost, double seconds) {
  return {{"scene", options.settings.scene},
          {"settings", options.settings},
          {"seed", seed_text(seed)},
          {"paths", cost.paths},
          {"rays", cost.rays},
          {"seconds", seconds},
          {"paths_per_second", static_cast<double>(cost.paths) / seconds},
          {"rays_per_second", static_cast<double>(cost.rays) / seconds},
          {"peak_bytes", peak_bytes()}};
}

bool same_file(const std::string& a, const std::string& b) {
  namespace fs = std::filesystem;
  return fs::weakly_canonical(fs::absolute(a)) == fs::weakly_canonical(fs::absolute(b));
}

// No output may overwrite another, nor the picture that is resumed, but for the one that takes its place.
void check_outputs(const RenderOptions& options) {
  const std::vector<std::pair<std::string, std::string>> files{
      {"-o", options.output}, {"--png", options.png}, {"--json", options.json}, {"--resume", options.resume}};
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (i < 3 && !files[i].second.empty()) WholeFile::check_writable(files[i].second);
    for (std::size_t j = i + 1; j < files.size(); ++j) {
      const bool takes_its_place = i == 0 && j == 3;
      if (files[i].second.empty() || files[j].second.empty() || takes_its_place) continue;
      if (!same_file(files[i].second, files[j].second)) continue;
      throw std::invalid_argument(files[i].first + " and " + files[j].first + " name the same file, \"" +
                                  files[i].second + "\" (one would overwrite the other)");
    }
  }
}

void check_count(const Picture& picture, std::uint64_t spp) {
  const std::uint64_t held = picture.samples.total();
  if (spp > most_samples - held) {
    throw std::invalid_argument("a pixel can hold 2^32 - 1 samples (ask for fewer; the picture has " +
                                std::to_string(held) + ")");
  }
}

int render(const RenderOptions& options) {
  const View view = view_of(options.settings);
  check_outputs(options);
  const OutputLock lock(options.output);
  check_whole_sets(options.settings, options.spp);
  Picture picture = start(options);
  check_count(picture, options.spp);
  const std::uint64_t seed = choose_seed(options, picture);
  const std::uint32_t points = options.settings.points;
  const SampleRange range = shard_range(options.shard, picture.samples.next(seed), options.spp / points, points);
  picture.samples.add(seed, range);

  const auto begin = std::chrono::steady_clock::now();
  const RenderCost cost = render_image(view, options.settings, seed, range, options.threads, picture.film,
                                       progress_bar(options.settings.scene.c_str()), options.instructions);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();

  write_exr(options.output, picture);
  if (!options.png.empty()) write_png(options.png, picture.film);
  if (!options.json.empty()) write_json(options.json, report(options, seed, cost, seconds));
  std::printf("%s: %d x %d pixels, %llu samples each, %.1f s, seed %s: %s%s%s\n", options.settings.scene.c_str(),
              options.settings.width, options.settings.height,
              static_cast<unsigned long long>(picture.samples.total()), seconds, seed_text(seed).c_str(),
              options.output.c_str(), options.png.empty() ? "" : ", ", options.png.c_str());
  return 0;
}

int merge(const std::vector<std::string>& inputs, const std::string& output) {
  WholeFile::check_writable(output);
  const OutputLock lock(output);
  Picture picture = read_exr(inputs.front());
  for (std::size_t i = 1; i < inputs.size(); ++i) picture.merge(read_exr(inputs[i]));
  write_exr(output, picture);
  std::printf("%zu renders merged: %s\n", inputs.size(), output.c_str());
  return 0;
}

// An empty value is what an unset shell variable makes; it is not the same as no option.
std::string not_empty(const std::string& value) { return value.empty() ? "the value is empty" : ""; }

std::vector<std::string> instruction_names() {
  std::vector<std::string> names;
  for (const InstructionSet& set : instruction_sets()) names.push_back(set.name);
  return names;
}

void add_files(CLI::App& app, RenderOptions& options) {
  app.add_option("-o", options.output, "The picture, as EXR")->check(not_empty, "")->required()->type_name("F.exr");
  app.add_option("--png", options.png, "A preview, as PNG")->check(not_empty, "")->type_name("F.png");
  app.add_option("--json", options.json, "What it cost, as JSON")->check(not_empty, "")->type_name("F.json");
  app.add_option("--spp", options.spp, "Samples per pixel to add")
      ->required()
      ->check(CLI::Range(std::uint64_t{1}, most_samples));
  app.add_option("--resume", options.resume, "Go on from this picture, with its seed")
      ->check(not_empty, "")
      ->type_name("F.exr");
  app.add_option("--shard", options.shard, "Only part i of N of the samples")->type_name("i/N");
  app.add_option("--width", options.settings.width, "Pixels")->check(CLI::Range(1, 65536))->capture_default_str();
  app.add_option("--height", options.settings.height, "Pixels")->check(CLI::Range(1, 65536))->capture_default_str();
}

void add_strategies(CLI::App& app, RenderOptions& options) {
  RenderSettings& settings = options.settings;
  const auto choice = [&app](const char* name, std::string& value, const char* help,
                             std::vector<std::string> values) {
    app.add_option(name, value, help)->check(CLI::IsMember(std::move(values)))->capture_default_str();
  };
  choice("--real", settings.real, "Packets of floats, or doubles one at a time", {"packet", "double"});
  choice("--bounce", settings.bounce, "How directions are sampled", {"cosine", "uniform"});
  choice("--direct", settings.direct, "Shadow rays to luminaires, none, or shared with bounces",
         {"light", "none", "mis"});
  choice("--light-sampling", settings.light_sampling, "How a luminaire's points are sampled",
         {"area", "visible", "cone", "solid-angle"});
  choice("--which-light", settings.which_light, "All luminaires, or one of them: any, or by power or contribution",
         {"all", "one", "power", "contribution"});
  choice("--roulette", settings.roulette, "What decides whether a path goes on", {"albedo", "throughput", "off"});
  app.add_option("--roulette-depth", settings.roulette_depth,
                 "The first bounce that roulette may refuse; 1 by albedo and 5 by throughput if not given")
      ->check(CLI::Range(1, 1 << 20));
  choice("--filter", settings.filter, "The pixel filter", {"tent", "box", "gaussian", "blackman-harris"});
  choice("--random", settings.random, "Where random numbers come from", {"independent", "sobol", "stratified"});
  app.add_option("--points", options.points,
                 "Samples that sobol and stratified spread together: a power of two up to 1024; 16 if not given")
      ->check(CLI::Range(1, 1024));
  app.add_option("--max-depth", settings.max_depth, "Bounces after which a path ends")
      ->check(CLI::Range(0, 1 << 20));
}

void add_lens(CLI::App& app, RenderSettings& settings) {
  const CLI::Range any_size(0.0, std::numeric_limits<double>::max());
  app.add_option("--aperture", settings.aperture,
                 "The radius of the lens, 0 for a pinhole; the scene's own if not given")
      ->check(any_size);
  app.add_option("--focus", settings.focus, "The distance that is seen sharp; the scene's own if not given")
      ->check(any_size);
  app.add_option("--fov", settings.fov, "The vertical field of view in degrees; the scene's own if not given")
      ->check(any_size);
}

void add_render(CLI::App& program, Command& command) {
  auto* app = program.add_subcommand("render", "Render a built-in scene to an OpenEXR file");
  auto options = std::make_shared<RenderOptions>();
  app->add_option("scene", options->settings.scene, "Which scene: see `fairlight scenes`")
      ->required()
      ->type_name("SCENE");
  add_files(*app, *options);
  add_strategies(*app, *options);
  add_lens(*app, options->settings);
  app->add_option("--threads", options->threads, "Threads")->check(CLI::Range(1, 1024))->capture_default_str();
  app->add_option("--instructions", options->instructions, "What packets are worked on by; the widest if not given")
      ->check(CLI::IsMember(instruction_names()));
  app->add_option("--seed", options->seed, "1 to 16 hexadecimal digits; fresh if not given")->check(not_empty, "");
  app->callback([options, &command] {
    if (options->points != 0)
      options->settings.points = options->points;
    else if (options->settings.random != "independent")
      options->settings.points = usual_points;
    command = [options] { return render(*options); };
  });
}

void add_merge(CLI::App& program, Command& command) {
  auto* app = program.add_subcommand("merge", "Merge renders of one scene, with different samples, into one");
  auto inputs = std::make_shared<std::vector<std::string>>();
  auto output = std::make_shared<std::string>();
  app->add_option("pictures", *inputs, "Renders")->required()->type_name("F.exr");
  app->add_option("-o", *output, "The picture, as EXR")->required()->type_name("F.exr");
  app->callback([inputs, output, &command] { command = [inputs, output] { return merge(*inputs, *output); }; });
}

struct SheetOptions {
  std::string png;
  int size = 256;
  std::uint64_t spp = 256;
  int threads = hardware_threads();
};

int list_scenes(const SheetOptions& options) {
  for (const std::string& name : scene_names()) std::puts(name.c_str());
  if (options.png.empty()) return 0;
  WholeFile::check_writable(options.png);
  write_png(options.png,
            contact_sheet(options.size, options.spp, fresh_seed(), options.threads, progress_bar("scenes")));
  return 0;
}

void add_scenes(CLI::App& program, Command& command) {
  auto* app = program.add_subcommand("scenes", "List the built-in scenes; and show them all on one sheet");
  auto options = std::make_shared<SheetOptions>();
  app->add_option("--png", options->png, "Render them all, three in a row")
      ->check(not_empty, "")
      ->type_name("F.png");
  app->add_option("--size", options->size, "Pixels of each, across and down")
      ->check(CLI::Range(1, 4096))
      ->capture_default_str();
  app->add_option("--spp", options->spp, "Samples per pixel")
      ->check(CLI::Range(std::uint64_t{1}, most_samples))
      ->capture_default_str();
  app->add_option("--threads", options->threads, "Threads")->check(CLI::Range(1, 1024))->capture_default_str();
  app->callback([options, &command] { command = [options] { return list_scenes(*options); }; });
}

}  // namespace

void add_render_commands(CLI::App& program, Command& command) {
  add_render(program, command);
  add_merge(program, command);
  add_scenes(program, command);
}

}  // namespace fairlight
