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
  RandomNumbers random;
};

constexpr Strategy strategies[]{
    {"implicit, 16 times as many", DirectLighting::none, LightPoints::area, RandomNumbers::independent},
    {"area", DirectLighting::light, LightPoints::area, RandomNumbers::independent},
    {"visible hemisphere", DirectLighting::light, LightPoints::visible, RandomNumbers::independent},
    {"cone", DirectLighting::light, LightPoints::cone, RandomNumbers::independent},
    {"cone, shared with bounces", DirectLighting::mis, LightPoints::cone, RandomNumbers::independent},
    {"cone, stratified", DirectLighting::light, LightPoints::cone, RandomNumbers::stratified},
    {"cone, Sobol'", DirectLighting::light, LightPoints::cone, RandomNumbers::sobol},
};

// Implicit paths meet the light so seldom that few samples show no error at all.
constexpr std::uint64_t implicit_factor = 16;

Arm arm_of(const Strategy& strategy, std::uint64_t samples, int depth, const StudyOptions& options) {
  RenderSettings settings;
  settings.width = settings.height = options.quick ? 32 : 64;
  settings.direct = strategy.direct;
  settings.light_sampling = strategy.points;
  settings.random = strategy.random;
  settings.points = strategy.random == RandomNumbers::independent ? 1 : static_cast<std::uint32_t>(samples);
  settings.max_depth = depth;
  settings.roulette = depth < 0 ? RouletteKind::throughput : RouletteKind::off;
  return {formatted("cost %s %llu %d", strategy.name, static_cast<unsigned long long>(samples), depth),
          box_with_light(1.5), settings,
          strategy.direct == DirectLighting::none ? implicit_factor * samples : samples};
}

// The square error of the mean of a pixel, from two pictures: a picture of one set has no other.
double square_error_of_pair(const Film& a, const Film& b, const std::vector<bool>& counted) {
  double sum = 0, n = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      if (!counted[static_cast<std::size_t>(y * a.width() + x)]) continue;
      sum += (a.mean(x, y) - b.mean(x, y)).square().mean() / 2;
      ++n;
    }
  }
  return sum / n;
}

struct Level {
  std::uint64_t samples;
  std::vector<double> errors, seconds;  // root mean square error, CPU seconds: of pairs of pictures
};

std::vector<Level> levels_of(const Strategy& strategy, int depth, const StudyOptions& options, std::uint32_t pairs,
                             const std::vector<std::uint64_t>& samples, Steps& steps) {
  std::vector<Level> levels;
  for (const std::uint64_t n : samples) {
    const Arm arm = arm_of(strategy, n, depth, options);
    const std::vector<bool> counted = pixels_off_lights(arm.view, arm.settings.width, arm.settings.height);
    Level level{n, {}, {}};
    for (std::uint32_t pair = 0; pair < pairs; ++pair) {
      const TimedFilm a = render_arm(arm, options, 2 * pair), b = render_arm(arm, options, 2 * pair + 1);
      level.errors.push_back(std::sqrt(square_error_of_pair(a.film, b.film, counted)));
      level.seconds.push_back((a.seconds + b.seconds) / 2);
      steps.done();
    }
    levels.push_back(level);
  }
  return levels;
}

// The slopes of log(error) over log(samples), by least squares, one for each pair of pictures.
std::vector<double> slopes(const std::vector<Level>& levels) {
  std::vector<double> all;
  for (std::size_t pair = 0; pair < levels[0].errors.size(); ++pair) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (const Level& level : levels) {
      const double u = std::log(static_cast<double>(level.samples)), v = std::log(level.errors[pair]);
      n += 1, x += u, y += v, xx += u * u, xy += u * v;
    }
    all.push_back((n * xy - x * y) / (n * xx - x * x));
  }
  return all;
}

std::string chart_of(const char* title, const std::vector<std::vector<Level>>& all) {
  std::string script = formatted("set title '%s'\n", title), plot = "plot ";
  for (std::size_t s = 0; s < all.size(); ++s) {
    script += formatted("$s%zu << EOD\n", s);
    for (const Level& level : all[s]) {
      const Measured error = measured_mean(level.errors);
      script += formatted("%.5g %.5g %.5g %.5g\n", measured_mean(level.seconds).value, error.value,
                          error.interval.lo, error.interval.hi);
    }
    script += "EOD\n";
    plot +=
        formatted("$s%zu using 1:2:3:4 with yerrorlines lw 1.5 pt 7 ps 0.6 title \"%s\", ", s, strategies[s].name);
  }
  const Level& last = all[3].back();
  const double constant = measured_mean(last.errors).value * std::sqrt(measured_mean(last.seconds).value);
  return script + plot + formatted("%.5g / sqrt(x) dt 2 lc rgb 'black' title '1 / sqrt(time)'\n", constant);
}

void add_rows(StudyTable& table, const char* light, const std::vector<std::vector<Level>>& all) {
  for (std::size_t s = 0; s < all.size(); ++s) {
    const Level& last = all[s].back();
    table.rows.push_back({light, strategies[s].name, measured_mean(slopes(all[s])), measured_mean(last.errors),
                          measured_ratio(all[s].front().errors, last.errors), measured_mean(last.seconds)});
  }
}

}  // namespace

StudyResult cost(const StudyOptions& options) {
  const std::uint32_t pairs = options.quick ? 3 : 6;
  const std::vector<std::uint64_t> samples = options.quick ? std::vector<std::uint64_t>{1, 4, 16, 64}
                                                           : std::vector<std::uint64_t>{1, 4, 16, 64, 256, 1024};
  Steps steps(options, 2 * std::size(strategies) * samples.size() * pairs);
  StudyResult result;
  result.text =
      "The error of a picture of independent samples falls like 1 / sqrt(n): the slope of its logarithm over that "
      "of the "
      "number of samples is -1/2. Sets of Sobol' points and of strata, here one set for a whole picture, do better "
      "for "
      "direct light, which has few dimensions. With all bounces most of the error is in dimensions that no set "
      "stratifies "
      "together. Error: root mean square error of a pixel off the light, from pairs of pictures.";
  StudyTable table{"slopes",
                   formatted("%llu samples a pixel at the last level, of implicit paths 16 times as many.",
                             static_cast<unsigned long long>(samples.back())),
                   {{"light"},
                    {"strategy"},
                    {"slope"},
                    {"error at last level"},
                    {"error at 1 sample / at last level"},
                    {"CPU seconds at last level", true}},
                   {}};
  std::string charts =
      "set logscale xy; set format '10^{%T}'; set xlabel 'CPU seconds of a picture'\n"
      "set ylabel 'error [W/(sr m^2)]'; set key outside bottom center horizontal Left reverse; "
      "set termoption enhanced\n";
  for (const int depth : {1, -1}) {
    std::vector<std::vector<Level>> all;
    for (const Strategy& strategy : strategies)
      all.push_back(levels_of(strategy, depth, options, pairs, samples, steps));
    add_rows(table, depth == 1 ? "direct" : "all", all);
    charts += chart_of(depth == 1 ? "direct light" : "all light", all);
  }
  result.tables.push_back(table);
  result.pictures.push_back(
      write_study_chart(options, "cost",
                        "Error against CPU time, with the line 1 / sqrt(time) through the last point "
                        "of the cone. The times depend on the clock.",
                        "Error against time", 1300, 620, "1,2", charts));
  return result;
}

}  // namespace fairlight::studies_of_paper
