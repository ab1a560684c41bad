#include <fairlight/render/instruction_sets.h>
#include <fairlight/validation/app/render_options.h>

namespace fairlight {
namespace {

std::vector<std::string> instruction_names() {
  std::vector<std::string> names;
  for (const InstructionSet& set : instruction_sets()) names.push_back(set.name);
  return names;
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
  add_choice(app, "--filter", settings.filter, {"tent", "box", "gaussian", "blackman-harris"},
             "Filter pixels by this.")
      ->capture_default_str();
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
  add_choice(app, "--random", options.settings.random, {"independent", "sobol", "stratified"},
             "Take random numbers from this source.")
      ->capture_default_str();
  add_count(app, "--points", options.points, std::uint32_t{1}, std::uint32_t{1024},
            "Spread this many samples together, a power of two: of sobol and stratified, 16 if not given.");
}

void add_strategies(CLI::App& app, RenderSettings& settings) {
  begin_group(app, "Strategies");
  const auto choice = [&app](const char* name, std::string& value, const std::vector<std::string>& values,
                             const char* help) {
    add_choice(app, name, value, values, help)->capture_default_str();
  };
  choice("--bounce", settings.bounce, {"cosine", "uniform"}, "Sample the directions of diffuse bounces so.");
  choice("--direct", settings.direct, {"light", "none", "mis"},
         "Find light by shadow rays alone, by bounces alone, or by both with the balance heuristic.");
  choice("--light-sampling", settings.light_sampling, {"area", "visible", "cone", "solid-angle"},
         "Sample points of a light so: visible and cone are for spheres, solid-angle is for rectangles.");
  choice("--which-light", settings.which_light, {"all", "one", "power", "contribution"},
         "Send shadow rays to all lights, or to one: any, or chosen by power or by contribution.");
  choice("--roulette", settings.roulette, {"albedo", "throughput", "off"},
         "Let paths survive a bounce with the surface's albedo, with their throughput, or always.");
  add_count(app, "--roulette-depth", settings.roulette_depth, 1, 1 << 20,
            "End paths by roulette from this bounce on: 1 by albedo and 5 by throughput if not given.");
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
  add_choice(app, "--real", options.settings.real, {"packet", "double"},
             "Trace packets of paths in floats, or one path at a time in doubles.")
      ->capture_default_str();
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
