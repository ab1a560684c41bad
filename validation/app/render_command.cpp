#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>

#include <sys/resource.h>

#include <fairlight/render/atomic_file.h>
#include <fairlight/render/contact_sheet.h>
#include <fairlight/render/file_lock.h>
#include <fairlight/render/instruction_sets.h>
#include <fairlight/render/parallel.h>
#include <fairlight/render/picture.h>
#include <fairlight/render/render_image.h>
#include <fairlight/stats/seed.h>
#include <fairlight/validation/app/options.h>
#include <fairlight/validation/app/progress.h>
#include <fairlight/validation/app/render_command.h>
#include <fairlight/validation/app/render_options.h>

namespace fairlight {
namespace {

constexpr unsigned long most_shards = 65536;
constexpr std::uint32_t usual_points = 16;

// The samples of shard i of N: the sets from (i-1) sets / N to i sets / N, each of `points`
// samples.
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
  empty.merge(picture);  // throws for a picture of other settings
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

// Refuses an output that would overwrite another output or the resumed picture. Only -o may replace
// the resumed picture.
void check_outputs(const RenderOptions& options) {
  const std::vector<std::pair<std::string, std::string>> files{
      {"-o", options.output}, {"--png", options.png}, {"--json", options.json}, {"--resume", options.resume}};
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (i < 3 && !files[i].second.empty()) AtomicFile::check_writable(files[i].second);
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
  AtomicFile::check_writable(output);
  const OutputLock lock(output);
  Picture picture = read_exr(inputs.front());
  for (std::size_t i = 1; i < inputs.size(); ++i) picture.merge(read_exr(inputs[i]));
  write_exr(output, picture);
  std::printf("%zu renders merged: %s\n", inputs.size(), output.c_str());
  return 0;
}

void add_render(CLI::App& program, Command& command) {
  auto* app = program.add_subcommand("render", "Render a scene to an OpenEXR file.");
  auto options = std::make_shared<RenderOptions>();
  add_render_options(*app, *options);
  add_examples(*app, {"fairlight render cornell-simple --spp 256 -o box.exr --png box.png",
                      "fairlight render hallway --spp 64 --aperture 4 --focus 230 -o hallway.exr",
                      "fairlight render cornell-simple --spp 256 --resume box.exr -o box.exr"});
  app->callback([options, &command] {
    if (options->points != 0)
      options->settings.points = options->points;
    else if (options->settings.random != RandomNumbers::independent)
      options->settings.points = usual_points;
    command = [options] { return render(*options); };
  });
}

void add_merge(CLI::App& program, Command& command) {
  auto* app = program.add_subcommand("merge", "Merge renders of one scene, with different samples, into one.");
  auto inputs = std::make_shared<std::vector<std::string>>();
  auto output = std::make_shared<std::string>();
  begin_group(*app, "Files");
  app->add_option("pictures", *inputs, "Merge these renders, all made with the same settings.")
      ->required()
      ->type_name("F.exr");
  add_text(*app, "-o", *output, "F.exr", "Write the merged picture to this OpenEXR file.")->required();
  add_examples(*app, {"fairlight merge shard1.exr shard2.exr -o box.exr"});
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
  AtomicFile::check_writable(options.png);
  write_png(options.png,
            contact_sheet(options.size, options.spp, fresh_seed(), options.threads, progress_bar("scenes")));
  return 0;
}

void add_scenes(CLI::App& program, Command& command) {
  auto* app = program.add_subcommand("scenes", "List the built-in scenes, and render them all on one sheet.");
  auto options = std::make_shared<SheetOptions>();
  begin_group(*app, "Sheet");
  add_text(*app, "--png", options->png, "F.png", "Render all scenes, three in a row, to this PNG file.");
  add_count(*app, "--size", options->size, 1, 4096, "Make each scene this many pixels wide and high.")
      ->capture_default_str();
  add_count(*app, "--spp", options->spp, std::uint64_t{1}, most_samples, "Take this many samples of every pixel.")
      ->capture_default_str();
  add_threads(*app, options->threads);
  add_examples(*app, {"fairlight scenes", "fairlight scenes --png scenes.png --size 128 --spp 64"});
  app->callback([options, &command] { command = [options] { return list_scenes(*options); }; });
}

}  // namespace

void add_render_commands(CLI::App& program, Command& command) {
  add_render(program, command);
  add_merge(program, command);
  add_scenes(program, command);
}

}  // namespace fairlight
