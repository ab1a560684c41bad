#include <fairlight/estimators/glossy.h>
#include <fairlight/estimators/hemisphere.h>
#include <fairlight/estimators/lambertian.h>
#include <fairlight/estimators/stream.h>
#include <fairlight/stats/moments.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/studies/all_studies.h>
#include <fairlight/validation/studies/closed_forms.h>
#include <fairlight/validation/studies/pictures.h>
#include <fairlight/validation/studies/renders.h>

namespace fairlight::studies_of_paper {
namespace {

Rgb<double> white() { return {1, 1, 1}; }

// The variances of blocks of draws of the radiance that a surface reflects upwards, under a sky that
// is bright where x > 0.
template <class Surface>
std::vector<double> block_variances(const Surface& surface, const StreamKey& key, std::uint32_t blocks) {
  std::vector<double> variances, draws(4096);
  for (std::uint32_t block = 0; block < blocks; ++block) {
    for (std::size_t i = 0; i < draws.size(); ++i) {
      PhiloxStream<double> source(key, block, i);
      const Bounce<double> bounce = surface.sample(Vec3<double>(0, 0, 1), next_pair<double>(source));
      draws[i] = bounce.in.x() > 0 ? bounce.weight[0] : 0;
    }
    variances.push_back(Moments::of(draws).variance());
  }
  return variances;
}

struct Row {
  std::string name;
  double uniform, importance;  // closed forms
};

template <class Uniform, class Importance>
std::vector<Cell> row(const Row& closed, const Uniform& uniform, const Importance& importance,
                      const StudyOptions& options, std::uint32_t blocks) {
  const auto variances = [&](const auto& surface, const char* how) {
    return block_variances(surface, StreamKey(options.seed, formatted("fig1 %s %s", closed.name.c_str(), how)),
                           blocks);
  };
  const std::vector<double> by_uniform = variances(uniform, "uniform"), by_brdf = variances(importance, "brdf");
  return {closed.name,
          measured_mean(by_uniform),
          closed.uniform,
          measured_mean(by_brdf),
          closed.importance,
          measured_ratio(by_uniform, by_brdf),
          closed.uniform / closed.importance};
}

StudyTable variances(const StudyOptions& options) {
  const std::uint32_t blocks = options.quick ? 100 : 2500;
  StudyTable table{
      "variances",
      "Variance of one draw of the reflected radiance, at normal incidence and albedo 1, under a sky that "
      "is bright on one side of a vertical plane: directions uniform over the hemisphere, and by the BRDF.",
      {{"surface"},
       {"uniform"},
       {"closed form"},
       {"by BRDF"},
       {"closed form"},
       {"uniform / by BRDF"},
       {"closed form"}},
      {}};
  Steps steps(options, 4);
  table.rows.push_back(
      row({"diffuse", closed_forms::diffuse_uniform_variance(), closed_forms::diffuse_cosine_variance()},
          Lambertian<double, UniformHemisphere>(white()), Lambertian<double>(white()), options, blocks));
  steps.done();
  for (const double n : {5.0, 50.0, 500.0}) {
    table.rows.push_back(row({formatted("glossy, exponent %g", n), closed_forms::glossy_uniform_variance(n),
                              closed_forms::glossy_lobe_variance(n)},
                             Glossy<double, UniformHemisphere>(white(), n), Glossy<double>(white(), n), options,
                             blocks));
    steps.done();
  }
  return table;
}

// A panel: the lobe f cos in the plane of incidence, scaled to 1, and the directions drawn.
template <class Surface>
std::string panel(const std::string& title, const Surface& surface, const char* colour,
                  const StudyOptions& options) {
  const Vec3<double> out = Vec3<double>(-1, 0, 1).normalized();
  double most = 0;
  constexpr int points = 180;
  const auto towards = [](int i) {
    const double angle = std::numbers::pi * (i + 0.5) / points;
    return Vec3<double>(std::cos(angle), 0, std::sin(angle));
  };
  const auto value = [&](int i) { return surface.eval(out, towards(i))[0] * towards(i).z(); };
  for (int i = 0; i < points; ++i) most = std::max(most, value(i));
  std::string script = "$lobe << EOD\n";
  for (int i = 0; i < points; ++i)
    script += formatted("%.4f %.4f\n", value(i) / most * towards(i).x(), value(i) / most * towards(i).z());
  script += "EOD\n$drawn << EOD\n";
  const StreamKey key(options.seed, "fig1 " + title);
  for (std::uint32_t i = 0; i < 120; ++i) {
    PhiloxStream<double> source(key, 0, i);
    const Vec3<double> in = surface.sample(out, next_pair<double>(source)).in;
    script += formatted("%.4f %.4f\n", in.x(), in.z());
  }
  return script + formatted("EOD\nset title '%s'\n", title.c_str()) +
         formatted(
             "plot $lobe with filledcurves closed lc rgb '#c8c8c8' notitle, "
             "$drawn using (0):(0):1:2 with vectors nohead lw 1 lc rgb %s notitle, "
             "'+' using (0):(0):(-0.7071):(0.7071) every ::::0 with vectors lw 2 lc rgb 'black' notitle\n",
             colour);
}

StudyPicture directions(const StudyOptions& options) {
  std::string script =
      "unset key; unset tics; unset border; set size ratio -1; set xrange [-1:1]; set yrange [-0.05:1.05]\n";
  script += panel("diffuse, uniform", Lambertian<double, UniformHemisphere>(white()), "blue", options);
  script += panel("diffuse, by BRDF", Lambertian<double>(white()), "orange", options);
  for (const double n : {20.0, 200.0}) {
    script += panel(formatted("glossy, exponent %g, uniform", n), Glossy<double, UniformHemisphere>(white(), n),
                    "blue", options);
    script += panel(formatted("glossy, exponent %g, by BRDF", n), Glossy<double>(white(), n), "orange", options);
  }
  return write_study_chart(
      options, "fig1",
      "120 directions over the lobe f cos (grey, scaled), seen from the side: uniform (blue) and by "
      "the BRDF (orange). The arrow leads to the eye.",
      "Directions of a bounce", 1200, 520, "2,3", script);
}

}  // namespace

StudyResult fig1(const StudyOptions& options) {
  StudyResult result;
  result.text =
      "A bounce in a direction drawn from the BRDF carries a nearly constant weight; one in a uniform direction "
      "carries "
      "f cos / p, which is mostly small and seldom large. The sharper the lobe, the larger the gain: with an "
      "exponent n "
      "the ratio of the variances grows like n.";
  result.tables.push_back(variances(options));
  result.pictures.push_back(directions(options));
  return result;
}

}  // namespace fairlight::studies_of_paper
