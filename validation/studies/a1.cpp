#include <fairlight/estimators/stream.h>
#include <fairlight/stats/moments.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/studies/all_studies.h>
#include <fairlight/validation/studies/closed_forms.h>
#include <fairlight/validation/studies/pictures.h>
#include <fairlight/validation/studies/renders.h>
#include <fairlight/validation/studies/scenes.h>

namespace fairlight::studies_of_paper {
namespace {

using Probabilities = std::array<double, 6>;
constexpr Probabilities low{0.5, 0.2, 0.1, 0.1, 0.05, 0.05}, high{0.05, 0.05, 0.1, 0.1, 0.1, 0.6};

int thrown(const Probabilities& die, double u) {
  int face = 1;
  for (double sum = die[0]; face < 6 && u >= sum; ++face) sum += die[static_cast<std::size_t>(face)];
  return face;
}

struct Throws {
  std::vector<double> means, variances;  // of blocks
};

// Blocks of scores, each a function of a source.
template <class Score>
Throws throws(const StudyOptions& options, const char* purpose, const Score& score) {
  const StreamKey key(options.seed, purpose);
  Throws blocks;
  std::vector<double> scores(4096);
  for (std::uint32_t block = 0; block < (options.quick ? 50u : 1000u); ++block) {
    for (std::size_t i = 0; i < scores.size(); ++i) {
      PhiloxStream<double> source(key, block, i);
      scores[i] = score(source);
    }
    const Moments moments = Moments::of(scores);
    blocks.means.push_back(moments.mean());
    blocks.variances.push_back(moments.variance());
  }
  return blocks;
}

StudyTable dice(const StudyOptions& options) {
  const closed_forms::Die a = closed_forms::die_of(low), b = closed_forms::die_of(high);
  const Throws both = throws(options, "a1 both", [](auto& source) {
    const int first = thrown(low, source.next());
    return first + thrown(high, source.next());
  });
  const Throws one = throws(options, "a1 one", [](auto& source) {
    const bool first = source.next() < 0.5;
    return 2 * thrown(first ? low : high, source.next());
  });
  const Throws unpaid = throws(options, "a1 unpaid", [](auto& source) {
    const bool first = source.next() < 0.5;
    return thrown(first ? low : high, source.next());
  });
  const double mean = a.mean + b.mean;
  StudyTable table{
      "dice",
      "The paper's dice, weighted with 0.5, 0.2, 0.1, 0.1, 0.05, 0.05 and 0.05, 0.05, 0.1, 0.1, 0.1, 0.6: "
      "the score of one sample.",
      {{"sample"}, {"mean"}, {"closed form"}, {"variance"}, {"closed form"}},
      {}};
  table.rows.push_back({"both dice", measured_mean(both.means), mean, measured_mean(both.variances),
                        closed_forms::two_dice_variance(a, b)});
  table.rows.push_back({"one of them, times 2", measured_mean(one.means), mean, measured_mean(one.variances),
                        closed_forms::one_die_variance(a, b)});
  table.rows.push_back({"one of them, not times 2", measured_mean(unpaid.means), mean / 2,
                        measured_mean(unpaid.variances), closed_forms::one_die_variance(a, b) / 4});
  return table;
}

Arm arm_of(int lights, WhichLight which, const StudyOptions& options) {
  RenderSettings settings;
  settings.width = settings.height = options.quick ? 32 : 64;
  settings.light_sampling = LightPoints::cone;
  settings.which_light = which;
  const std::uint64_t samples = options.quick ? 4 : 32;
  return {formatted("a1 %d %s", lights, name_of(which)), box_with_lights(lights), settings,
          which == WhichLight::all && lights > 100 ? std::max<std::uint64_t>(2, samples / 16) : samples};
}

constexpr WhichLight choices[]{WhichLight::all, WhichLight::one, WhichLight::power, WhichLight::contribution};

StudyTable lights(const StudyOptions& options, Steps& steps, std::uint32_t replicates) {
  StudyTable table{
      "lights",
      "The box with |L| lights of unequal power. Relative to a shadow ray to every light: variance of a "
      "sample, its CPU time, efficiency 1 / (variance x time).",
      {{"lights"}, {"shadow rays to"}, {"variance"}, {"time", true}, {"efficiency", true}},
      {}};
  for (const int n : {2, 10, 100, 1000}) {
    std::vector<Arm> arms;
    for (const WhichLight which : choices) arms.push_back(arm_of(n, which, options));
    const std::vector<ArmRuns> runs = run_arms(arms, options, replicates, steps);
    for (std::size_t i = 0; i < runs.size(); ++i) {
      table.rows.push_back({static_cast<double>(n), row_of(choices[i]).help, variance_ratio(runs[i], runs[0]),
                            time_ratio(runs[i], runs[0]), efficiency_ratio(runs[i], runs[0])});
    }
  }
  return table;
}

StudyPicture pictures(const StudyOptions& options, Steps& steps) {
  std::vector<Captioned> shown;
  for (const WhichLight which : choices) {
    Arm arm = arm_of(100, which, options);
    arm.settings.width = arm.settings.height = options.quick ? 160 : 224;
    arm.samples = which == WhichLight::all ? 2 : 16;
    const TimedFilm timed = render_arm(arm, options, 1000);
    shown.push_back({timed.film, formatted("%s\n%llu samples, %.1f s", name_of(which),
                                           static_cast<unsigned long long>(arm.samples), timed.seconds)});
    steps.done();
  }
  return write_montage(options, "a1",
                       "100 lights of unequal power: shadow rays to all, and to one that is chosen "
                       "uniformly, by power, and by power over squared distance.",
                       shown, 4);
}

}  // namespace

StudyResult a1(const StudyOptions& options) {
  const std::uint32_t replicates = options.quick ? 3 : 10;
  Steps steps(options, 16 * replicates + 4);
  StudyResult result;
  result.text =
      "One of |L| lights, weighted by the inverse of its probability, has the mean of all of them. It has more "
      "variance, "
      "and costs less. The more lights there are, and the more unequal they are, the more it matters how the one "
      "is "
      "chosen.";
  result.tables.push_back(dice(options));
  result.tables.push_back(lights(options, steps, replicates));
  result.pictures.push_back(pictures(options, steps));
  return result;
}

}  // namespace fairlight::studies_of_paper
