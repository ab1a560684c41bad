#include <fairlight/stats/text.h>
#include <fairlight/validation/claims/closed_scenes.h>
#include <fairlight/validation/studies/all_studies.h>
#include <fairlight/validation/studies/pictures.h>
#include <fairlight/validation/studies/renders.h>
#include <fairlight/validation/studies/scenes.h>

namespace fairlight::studies_of_paper {
namespace {

struct Ending {
  const char* name;
  RouletteKind roulette;
  int depth;
};

constexpr Ending endings[]{
    {"depth 1", RouletteKind::off, 1},
    {"depth 2", RouletteKind::off, 2},
    {"depth 3", RouletteKind::off, 3},
    {"depth 10", RouletteKind::off, 10},
    {"depth 50", RouletteKind::off, 50},
    {"roulette by albedo", RouletteKind::albedo, -1},
    {"roulette by throughput", RouletteKind::throughput, -1},
};
constexpr std::size_t by_albedo = 5;

Arm arm_of(const char* scene, const View& view, const Ending& ending, const RenderSettings& base,
           std::uint64_t samples) {
  RenderSettings settings = base;
  settings.roulette = ending.roulette;
  settings.max_depth = ending.depth;
  return {formatted("fig3 %s %s", scene, ending.name), view, settings, samples};
}

// The mean of the channels of each replicate.
std::vector<double> grey_means(const ArmRuns& runs) {
  std::vector<double> means;
  for (const Rgb<double>& mean : runs.means) means.push_back(mean.mean());
  return means;
}

std::vector<Arm> arms_in(const char* scene, const View& view, const RenderSettings& base, std::uint64_t samples) {
  std::vector<Arm> arms;
  for (const Ending& ending : endings) arms.push_back(arm_of(scene, view, ending, base, samples));
  return arms;
}

// Every point of the outer sphere has the same radiance, so the camera sees it in all directions.
StudyTable in_furnace(const StudyOptions& options, std::uint32_t replicates, Steps& steps) {
  const ClosedScene furnace = concentric_spheres();
  RenderSettings base;
  base.width = base.height = 32;
  base.direct = DirectLighting::none;
  std::vector<Arm> arms = arms_in("furnace", furnace.view, base, options.quick ? 64 : 1024);
  // Lights are everywhere: all pixels count.
  std::vector<std::vector<double>> means(arms.size());
  const std::vector<bool> all(static_cast<std::size_t>(base.width * base.height), true);
  for (std::uint32_t replicate = 0; replicate < replicates; ++replicate) {
    for (std::size_t i = 0; i < arms.size(); ++i) {
      means[i].push_back(mean_radiance(render_arm(arms[i], options, replicate).film, all).mean());
      steps.done();
    }
  }
  const double whole = furnace.radiance(1000).mean();
  StudyTable table{
      "furnace",
      "Between concentric spheres that emit: radiance against its closed form by depth, and the bias of "
      "stopping there, in % of the whole radiance.",
      {{"paths end at"}, {"radiance"}, {"closed form"}, {"bias in %"}, {"closed form of bias"}},
      {}};
  for (std::size_t i = 0; i < arms.size(); ++i) {
    const double closed = endings[i].depth < 0 ? whole : furnace.radiance(endings[i].depth).mean();
    const Measured mean = measured_mean(means[i]);
    table.rows.push_back({endings[i].name, mean, closed,
                          in_percent({mean.value / whole, {mean.interval.lo / whole, mean.interval.hi / whole}}),
                          100 * (closed / whole - 1)});
  }
  return table;
}

StudyTable in_box(const StudyOptions& options, const std::vector<ArmRuns>& runs) {
  StudyTable table{
      "box",
      formatted("In `cornell-simple`, relative to roulette by albedo: the bias of the mean radiance by "
                "difference, variance at equal samples, CPU time of a sample, efficiency.%s",
                options.quick ? ""
                              : " Efficiency counts the variance alone: where paths are cut, the bias "
                                "stays whatever it costs."),
      {{"paths end at"}, {"bias in %"}, {"variance"}, {"time", true}, {"efficiency", true}},
      {}};
  const ArmRuns& roulette = runs[by_albedo];
  for (std::size_t i = 0; i < runs.size(); ++i) {
    table.rows.push_back({endings[i].name, in_percent(measured_ratio(grey_means(runs[i]), grey_means(roulette))),
                          variance_ratio(runs[i], roulette), time_ratio(runs[i], roulette),
                          efficiency_ratio(runs[i], roulette)});
  }
  return table;
}

StudyPicture pictures(const StudyOptions& options, const std::vector<Arm>& arms, Steps& steps) {
  std::vector<Captioned> shown;
  for (const std::size_t i : {0u, 1u, 2u, 3u, 5u}) {
    Arm arm = arms[i];
    arm.settings.width = arm.settings.height = options.quick ? 160 : 224;
    arm.samples = options.quick ? 32 : 256;
    const TimedFilm timed = render_arm(arm, options, 1000);
    shown.push_back({timed.film, formatted("%s\n%.1f s", endings[i].name, timed.seconds)});
    steps.done();
  }
  return write_montage(
      options, "fig3",
      formatted("Equal samples (%d). What a fixed depth cuts off is light that has been reflected more "
                "often; no number of samples brings it back.",
                options.quick ? 32 : 256),
      shown, 5);
}

}  // namespace

StudyResult fig3(const StudyOptions& options) {
  const std::uint32_t replicates = options.quick ? 4 : 16;
  const std::size_t n = std::size(endings);
  Steps steps(options, 2 * n * replicates + 5);
  RenderSettings base;
  base.width = base.height = options.quick ? 48 : 128;
  base.light_sampling = LightPoints::cone;
  const std::vector<Arm> arms = arms_in("box", box_with_light(1.5), base, options.quick ? 16 : 128);
  StudyResult result;
  result.text =
      "A path that stops after a fixed number of bounces loses the light of all longer paths. Roulette stops most "
      "paths "
      "as early, and pays the others for it, so the mean is right.";
  result.tables.push_back(in_furnace(options, replicates, steps));
  result.tables.push_back(in_box(options, run_arms(arms, options, replicates, steps)));
  result.pictures.push_back(pictures(options, arms, steps));
  return result;
}

}  // namespace fairlight::studies_of_paper
