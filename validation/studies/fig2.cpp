#include <algorithm>
#include <cmath>

#include <fairlight/stats/text.h>
#include <fairlight/validation/studies/all_studies.h>
#include <fairlight/validation/studies/pictures.h>
#include <fairlight/validation/studies/renders.h>
#include <fairlight/validation/studies/scenes.h>

namespace fairlight::studies_of_paper {
namespace {

struct Strategy {
  const char* name;
  DirectLighting direct;
  LightPoints points;
  bool best = false;  // with all that the kit has besides
};

constexpr Strategy strategies[]{
    {"implicit", DirectLighting::none, LightPoints::area},
    {"explicit, by area", DirectLighting::light, LightPoints::area},
    {"explicit, by visible hemisphere", DirectLighting::light, LightPoints::visible},
    {"explicit, by cone", DirectLighting::light, LightPoints::cone},
    {"best combination", DirectLighting::light, LightPoints::cone, true},
};

Arm arm_of(const Strategy& strategy, double radius, const StudyOptions& options) {
  RenderSettings settings;
  settings.width = settings.height = options.quick ? 48 : 128;
  settings.direct = strategy.direct;
  settings.light_sampling = strategy.points;
  std::uint64_t samples = options.quick ? 16 : 32;
  // An implicit path meets a light about as often as the light is large.
  if (strategy.direct == DirectLighting::none)
    samples *= radius > 5 ? 4 : radius > 1 ? 16 : options.quick ? 64 : 128;
  if (strategy.best) {
    settings.roulette = RouletteKind::throughput;
    settings.random = RandomNumbers::sobol;
    settings.points = 64;
    samples = 128;
  }
  return {formatted("fig2 %s %g", strategy.name, radius), box_with_light(radius), settings, samples};
}

StudyTable efficiencies(double radius, const StudyOptions& options, Steps& steps, std::vector<ArmRuns>& runs) {
  std::vector<Arm> arms;
  for (const Strategy& strategy : strategies) arms.push_back(arm_of(strategy, radius, options));
  runs = run_arms(arms, options, options.quick ? 4 : 12, steps);
  StudyTable table{
      formatted("radius-%g", radius),
      formatted("Light of radius %g m. Variance: the square error of one sample a pixel; efficiency: 1 / "
                "(variance x CPU time). Ratios to implicit, except the last column.",
                radius),
      {{"strategy"},
       {"variance"},
       {"variance of implicit / variance"},
       {"time / time of implicit", true},
       {"efficiency / implicit", true},
       {"efficiency / by area", true}},
      {}};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    table.rows.push_back({strategies[i].name, measured_mean(runs[i].square_errors),
                          variance_ratio(runs[0], runs[i]), time_ratio(runs[i], runs[0]),
                          efficiency_ratio(runs[i], runs[0]), efficiency_ratio(runs[i], runs[1])});
  }
  return table;
}

double mean_of(const std::vector<double>& values) { return measured_mean(values).value; }

// Pictures that each take about the same CPU time: the paper's figure.
StudyPicture at_equal_time(double radius, const StudyOptions& options, const std::vector<ArmRuns>& runs,
                           Steps& steps) {
  const int size = options.quick ? 160 : 224;
  const double seconds = options.quick ? 0.3 : 3;
  std::vector<Captioned> pictures;
  for (const std::size_t i : {0u, 1u, 3u, 4u}) {
    Arm arm = arm_of(strategies[i], radius, options);
    const double pixels = std::pow(static_cast<double>(size) / arm.settings.width, 2);
    arm.settings.width = arm.settings.height = size;
    const auto points = static_cast<double>(arm.settings.points);
    const double sets = std::max(2.0, std::round(seconds / (mean_of(runs[i].seconds) * pixels) / points));
    arm.samples = static_cast<std::uint64_t>(sets * points);
    const TimedFilm timed = render_arm(arm, options, 1000);
    const double error = std::sqrt(square_error(timed.film, pixels_off_lights(arm.view, size, size)));
    pictures.push_back({timed.film, formatted("%s\n%llu samples, %.1f s\nerror %.3f", strategies[i].name,
                                              static_cast<unsigned long long>(arm.samples), timed.seconds, error)});
    steps.done();
  }
  return write_montage(
      options, formatted("fig2-radius-%g", radius),
      formatted("A light of radius %g m at about equal CPU time. Error: root mean square error of a pixel "
                "[W/(sr m^2)]. The number of samples depends on the clock.",
                radius),
      pictures, 4);
}

}  // namespace

StudyResult fig2(const StudyOptions& options) {
  const std::vector<double> radii{8.5, 1.5, 0.15};
  const std::size_t replicates = options.quick ? 4 : 12;
  Steps steps(options, radii.size() * (std::size(strategies) * replicates + 4));
  StudyResult result;
  result.text =
      "The box of the paper with lights of three radii and one power; 1.5 m is the paper's. *Implicit* paths find "
      "the "
      "light by bounces alone, *explicit* ones by shadow rays. The best combination samples the cone, ends paths "
      "by "
      "throughput, and takes sets of 64 Sobol' points. Pixels within 3 of the visible light are left out: there "
      "the noise "
      "is that of the pixel filter. In each replicate every strategy renders once; the intervals are Fieller's "
      "over "
      "pairs. The paper claims that explicit sampling is more than 20 times faster at equal quality.";
  for (const double radius : radii) {
    std::vector<ArmRuns> runs;
    result.tables.push_back(efficiencies(radius, options, steps, runs));
    result.pictures.push_back(at_equal_time(radius, options, runs, steps));
  }
  return result;
}

}  // namespace fairlight::studies_of_paper
