#include <fairlight/render/instruction_sets.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/app/render_options.h>

namespace fairlight {
namespace {

std::vector<std::string> instruction_names() {
  std::vector<std::string> names;
  for (const InstructionSet& set : instruction_sets()) names.push_back(set.name);
  return names;
}

// The scenes that admit a strategy, as the end of its help.
const char* for_these(Scenes scenes) {
  if (scenes == Scenes::with_sphere_lights) return ", for spheres";
  if (scenes == Scenes::with_rectangle_lights) return ", for rectangles";
  return "";
}

// Adds the option of a kind of strategy. Its help has a line for each value.
template <class Strategy>
void add_strategy(CLI::App& app, Strategy& value) {
  using Table = StrategyTable<Strategy>;
  std::string help = Table::help;
  for (const StrategyRow<Strategy>& row : Table::rows)
    help += formatted("\n%s: %s%s (verify %s).", row.name, row.help, for_these(row.scenes), row.claims);
  const auto set = [&value](const std::string& name) { value = find_strategy<Strategy>(name)->value; };
  app.add_option_function<std::string>(option_of(Table::setting), set, help)
      ->check(one_of(strategy_names<Strategy>()))
      ->type_name("WORD")
      ->default_str(name_of(value));
}

void add_picture(CLI::App& app, RenderSettings& settings) {
  begin_group(app, "Picture");
  app.add_option("scene", settings.scene, "Render this built-in scene; `fairlight scenes` lists them.")
      ->required()
      ->type_name("SCENE");
  add_count(app, "--width", settings.width, 1, 65536, "Make the picture this many pixels wide.")
      ->capture_default_str();
  add_count(app, "--height", settings.height, 1, 65536, "Make the picture this many pixels high.")
      ->capture_default_str();
  add_strategy(app, settings.filter);
  const std::string or_scene = " The scene has its own.";
  add_number(app, "--aperture", settings.aperture, {.low = 0, .from_low = true},
             "Give the lens this radius in metres, for example 2.5; 0 is a pinhole." + or_scene);
  add_number(app, "--focus", settings.focus, {.low = 0},
             "Focus at this distance in metres, for example 230." + or_scene);
  add_number(app, "--fov", settings.fov, {.low = 0, .high = 180},
             "See this angle in degrees from bottom to top, for example 40." + or_scene);
}

void add_samples(CLI::App& app, RenderOptions& options) {
  begin_group(app, "Samples");
  add_count(app, "--spp", options.spp, std::uint64_t{1}, most_samples, "Add this many samples to every pixel.")
      ->required();
  add_text(app, "--resume", options.resume, "F.exr",
           "Go on from this picture, with its seed: the result is as if all samples came from one run.");
  add_text(app, "--shard", options.shard, "i/N",
           "Take only part i of N of the samples, for example 2/8; `fairlight merge` puts the parts together.");
  add_text(app, "--seed", options.seed, "HEX",
           "Draw random numbers from this seed, 1 to 16 hexadecimal digits. A fresh one if not given.");
  add_strategy(app, options.settings.random);
  add_count(app, "--points", options.points, std::uint32_t{1}, std::uint32_t{1024},
            formatted("Spread this many samples together, a power of two: of %s and %s, 16 if not given.",
                      name_of(RandomNumbers::sobol), name_of(RandomNumbers::stratified)));
}

void add_strategies(CLI::App& app, RenderSettings& settings) {
  begin_group(app, "Strategies");
  add_strategy(app, settings.bounce);
  add_strategy(app, settings.direct);
  add_strategy(app, settings.light_sampling);
  add_strategy(app, settings.which_light);
  add_strategy(app, settings.roulette);
  add_count(app, "--roulette-depth", settings.roulette_depth, 1, 1 << 20,
            formatted("End paths by roulette from this bounce on: 1 by %s and 5 by %s if not given.",
                      name_of(RouletteKind::albedo), name_of(RouletteKind::throughput)));
  add_count(app, "--max-depth", settings.max_depth, 0, 1 << 20,
            "End paths after this many bounces. No limit if not given.");
}

void add_files(CLI::App& app, RenderOptions& options) {
  begin_group(app, "Files");
  add_text(app, "-o", options.output, "F.exr", "Write the picture to this OpenEXR file.")->required();
  add_text(app, "--png", options.png, "F.png", "Write a preview to this PNG file.");
  add_text(app, "--json", options.json, "F.json", "Write the paths, rays, seconds and memory to this JSON file.");
}

void add_running(CLI::App& app, RenderOptions& options) {
  begin_group(app, "Running");
  add_threads(app, options.threads);
  add_strategy(app, options.settings.real);
  add_choice(app, "--instructions", options.instructions, instruction_names(),
             "Trace packets by this instruction set. The widest of this machine if not given.");
}

}  // namespace

void add_render_options(CLI::App& app, RenderOptions& options) {
  add_picture(app, options.settings);
  add_samples(app, options);
  add_strategies(app, options.settings);
  add_files(app, options);
  add_running(app, options);
}

}  // namespace fairlight
