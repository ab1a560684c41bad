#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include <fairlight/stats/expectation.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/checks/bsdf_checks.h>

namespace fairlight {
namespace {

constexpr int draws = 1 << 14;

// The largest violation of an identity, and where it was.
struct Identity {
  const char* check;
  const char* statement;
  double worst = 0;
  std::string where{};

  // `place()` says where; it is called for a new largest violation alone.
  void see(double gap, const auto& place) {
    if (gap <= worst) return;
    worst = gap;
    where = place();
  }
};

std::string text(const Vec3<double>& w) { return formatted("(%.6g, %.6g, %.6g)", w.x(), w.y(), w.z()); }

std::string text(const Rgb<double>& c) { return formatted("(%.6g, %.6g, %.6g)", c[0], c[1], c[2]); }

// The difference relative to the larger magnitude; infinite where one is not finite. Values near the
// smallest floats keep few digits, so those below 1e-20, which nobody sees, count as 1e-20.
double gap_between(double x, double y) {
  if (!std::isfinite(x) || !std::isfinite(y)) return infinity<double>;
  return std::abs(x - y) / std::max({std::abs(x), std::abs(y), 1e-20});
}

double gap_between(const Rgb<double>& x, const Rgb<double>& y) {
  double gap = 0;
  for (int c = 0; c < 3; ++c) gap = std::max(gap, gap_between(x[c], y[c]));
  return gap;
}

bool valid(double x) { return std::isfinite(x) && x >= 0; }
bool valid(const Rgb<double>& c) { return valid(c[0]) && valid(c[1]) && valid(c[2]); }

// What is wrong with a sample by itself; empty if nothing is.
std::string problem_of(const BsdfSample& sample, double rounding) {
  if (!all_finite(sample.in)) return "its direction is " + text(sample.in);
  if (std::abs(sample.in.norm() - 1) > rounding) return "its direction is no unit vector: " + text(sample.in);
  if (!valid(sample.weight)) return "its weight is " + text(sample.weight);
  if (!valid(sample.pdf)) return formatted("its pdf is %g", sample.pdf);
  return {};
}

// The identities of a BSDF, in the order in which a reader should hear of a violation.
class Identities {
 public:
  Identities(const BsdfUnderTest& bsdf, const BsdfTerms& terms, Generator generator)
      : bsdf_(bsdf), terms_(terms), generator_(generator) {}

  double next() { return static_cast<double>(generator_() >> 11) * 0x1p-53; }
  Vec3<double> direction(double lowest) {
    const double side = terms_.both_sides && next() < 0.5 ? -1 : 1;
    return drawn_direction(lowest, 1, side, [this] { return next(); });
  }

  // Every combination of edge numbers, for a new direction.
  void at_edges() {
    constexpr std::array<double, 5> numbers{0, 0x1p-53, 0.5, 1 - 0x1p-24, 1 - 0x1p-53};
    std::vector<double> u(bsdf_.dimensions);
    const Vec3<double> out = direction(1e-4);
    std::size_t combinations = 1;
    for (std::size_t d = 0; d < u.size(); ++d) combinations *= numbers.size();
    for (std::size_t k = 0; k < combinations; ++k) {
      std::size_t rest = k;
      for (double& x : u) {
        x = numbers[rest % numbers.size()];
        rest /= numbers.size();
      }
      see_problem(edges_, out, u);
    }
  }

  void at_a_draw() {
    const Vec3<double> out = direction(1e-4);
    std::vector<double> u(bsdf_.dimensions);
    for (double& x : u) x = next();
    const std::optional<BsdfSample> sample = see_problem(finite_, out, u);
    const Vec3<double> any = drawn_direction(1e-4, 1, next() - 0.5, [this] { return next(); });
    see_values(out, any);
    if (!sample) return;
    if (sample->pdf == 0) return see_single(out, *sample);
    see_values(out, sample->in);
    see_sample(out, *sample);
  }

  std::vector<Identity> all() const {
    std::vector<Identity> those{edges_, finite_, density_, weight_, single_, unsampled_};
    if (terms_.reciprocal) those.push_back(reciprocity_);
    return those;
  }

 private:
  std::string place(const Vec3<double>& out, const Vec3<double>& in) const {
    return "out = " + text(out) + ", in = " + text(in);
  }

  std::optional<BsdfSample> see_problem(Identity& identity, const Vec3<double>& out, const std::vector<double>& u) {
    const std::optional<BsdfSample> sample = bsdf_.sample(out, u);
    const std::string problem = sample ? problem_of(*sample, terms_.rounding) : std::string();
    if (problem.empty()) return sample;
    identity.see(infinity<double>, [&] {
      std::ostringstream numbers;
      numbers.precision(17);
      for (const double x : u) numbers << ' ' << x;
      return "the sample of out = " + text(out) + " from" + numbers.str() + ": " + problem;
    });
    return {};
  }

  void see_values(const Vec3<double>& out, const Vec3<double>& in) {
    const Rgb<double> f = bsdf_.eval(out, in);
    const double p = bsdf_.pdf(out, in);
    if (!valid(f)) finite_.see(infinity<double>, [&] { return "f = " + text(f) + " at " + place(out, in); });
    if (!valid(p)) finite_.see(infinity<double>, [&] { return formatted("pdf = %g at ", p) + place(out, in); });
    // In units of the f |cos| of a white diffuse surface.
    const double light = max_channel<double>(f) * std::abs(in.z()) * std::numbers::pi;
    if (p == 0) unsampled_.see(light, [&] { return "f = " + text(f) + ", pdf = 0 at " + place(out, in); });
    if (!terms_.reciprocal || in.z() * out.z() <= 0) return;
    const Rgb<double> other = bsdf_.eval(in, out);
    reciprocity_.see(gap_between(f, other),
                     [&] { return text(f) + " and " + text(other) + " at " + place(out, in); });
  }

  void see_single(const Vec3<double>& out, const BsdfSample& sample) {
    const Rgb<double> f = bsdf_.eval(out, sample.in);
    const double p = bsdf_.pdf(out, sample.in);
    if (p == 0 && max_channel<double>(f) == 0) return;
    single_.see(1, [&] { return formatted("pdf = %g, f = ", p) + text(f) + " at " + place(out, sample.in); });
  }

  void see_sample(const Vec3<double>& out, const BsdfSample& sample) {
    const double p = bsdf_.pdf(out, sample.in);
    density_.see(gap_between(sample.pdf, p), [&] {
      return formatted("the sample's pdf is %g, pdf(out, in) is %g at ", sample.pdf, p) + place(out, sample.in);
    });
    if (!(p > 0)) return;
    const Rgb<double> expected = bsdf_.eval(out, sample.in) * std::abs(sample.in.z()) / p;
    weight_.see(gap_between(sample.weight, expected), [&] {
      return "the sample's weight is " + text(sample.weight) + ", f |cos| / pdf is " + text(expected) + " at " +
             place(out, sample.in);
    });
  }

  const BsdfUnderTest& bsdf_;
  const BsdfTerms& terms_;
  Generator generator_;
  Identity edges_{"edge numbers", "numbers at the edge of [0,1) give valid samples"};
  Identity finite_{"finite", "samples, f and pdf are finite, and none is negative"};
  Identity density_{"density", "a sample comes with the pdf of its direction"};
  Identity weight_{"weight", "the weight of a sample is f |cos| / pdf"};
  Identity single_{"single directions", "a single direction has neither f nor pdf"};
  Identity unsampled_{"unsampled light", "f is 0 where the pdf is 0"};
  Identity reciprocity_{"reciprocity", "f is the same with both directions exchanged"};
};

BsdfFinding finding_of(const Trial& trial, const Identity& identity, double rounding) {
  Finding finding;
  finding.verdict = identity.worst > rounding ? Verdict::biased : Verdict::certified;
  finding.guarantee = Guarantee::exact;
  finding.margin = rounding;
  finding.bias = identity.worst;
  finding.interval = {0, identity.worst};
  finding.draws = draws;
  finding.note = finding.verdict == Verdict::biased
                     ? identity.where
                     : formatted("shown for all but a share of %.1e of draws", -std::log(trial.beta) / draws);
  return {identity.check, identity.statement, with_token(trial, finding)};
}

}  // namespace

Vec3<double> drawn_direction(double lowest, double highest, double side, const std::function<double()>& next) {
  const double z = std::min(1.0, lowest * std::pow(highest / lowest, next()));
  const double r = std::sqrt((1 - z) * (1 + z)), angle = 2 * std::numbers::pi * next();
  return {r * std::cos(angle), r * std::sin(angle), side < 0 ? -z : z};
}

std::vector<BsdfFinding> check_bsdf_identities(const Trial& trial, const BsdfUnderTest& bsdf,
                                               const BsdfTerms& terms) {
  Identities identities(bsdf, terms, generator_for(trial, "identities"));
  for (int i = 0; i < 16; ++i) identities.at_edges();
  for (int i = 0; i < draws; ++i) identities.at_a_draw();
  std::vector<BsdfFinding> findings;
  for (const Identity& identity : identities.all()) findings.push_back(finding_of(trial, identity, terms.rounding));
  return findings;
}

}  // namespace fairlight
