#include <algorithm>
#include <cmath>
#include <numbers>

#include <fairlight/stats/text.h>
#include <fairlight/validation/checks/bsdf_checks.h>
#include <fairlight/validation/checks/identity.h>

namespace fairlight {
namespace {

// What is wrong with a sample by itself; empty if nothing is.
std::string problem_with(const BsdfSample& sample, double rounding) {
  if (!is_valid(sample.weight)) return "its weight is " + text_of(sample.weight);
  return problem_of(sample.in, sample.pdf, rounding);
}

// The identities of a BSDF, in the order in which a reader should hear of a violation.
class Identities {
 public:
  Identities(const BsdfUnderTest& bsdf, const BsdfTerms& terms, Generator generator)
      : bsdf_(bsdf), terms_(terms), generator_(generator) {}

  double next() { return uniform(generator_); }
  Vec3<double> direction(double lowest) {
    const double side = terms_.both_sides && next() < 0.5 ? -1 : 1;
    return drawn_direction(lowest, 1, side, [this] { return next(); });
  }

  // Numbers at the edge, for a new direction.
  void at_edges() {
    const Vec3<double> out = direction(1e-4);
    for_each_edge(bsdf_.dimensions, [&](const std::vector<double>& u) { see_problem(edges_, out, u); });
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
    return "out = " + text_of(out) + ", in = " + text_of(in);
  }

  std::optional<BsdfSample> see_problem(Identity& identity, const Vec3<double>& out, const std::vector<double>& u) {
    const std::optional<BsdfSample> sample = bsdf_.sample(out, u);
    const std::string problem = sample ? problem_with(*sample, terms_.rounding) : std::string();
    if (problem.empty()) return sample;
    identity.see(infinity<double>,
                 [&] { return "the sample of out = " + text_of(out) + " from " + text_of(u) + ": " + problem; });
    return {};
  }

  void see_values(const Vec3<double>& out, const Vec3<double>& in) {
    const Rgb<double> f = bsdf_.eval(out, in);
    const double p = bsdf_.pdf(out, in);
    if (!is_valid(f)) finite_.see(infinity<double>, [&] { return "f = " + text_of(f) + " at " + place(out, in); });
    if (!is_valid(p)) finite_.see(infinity<double>, [&] { return formatted("pdf = %g at ", p) + place(out, in); });
    // In units of the f |cos| of a white diffuse surface.
    const double light = max_channel<double>(f) * std::abs(in.z()) * std::numbers::pi;
    if (p == 0) unsampled_.see(light, [&] { return "f = " + text_of(f) + ", pdf = 0 at " + place(out, in); });
    if (!terms_.reciprocal || in.z() * out.z() <= 0) return;
    const Rgb<double> other = bsdf_.eval(in, out);
    reciprocity_.see(gap_between(f, other),
                     [&] { return text_of(f) + " and " + text_of(other) + " at " + place(out, in); });
  }

  void see_single(const Vec3<double>& out, const BsdfSample& sample) {
    const Rgb<double> f = bsdf_.eval(out, sample.in);
    const double p = bsdf_.pdf(out, sample.in);
    if (p == 0 && max_channel<double>(f) == 0) return;
    single_.see(1, [&] { return formatted("pdf = %g, f = ", p) + text_of(f) + " at " + place(out, sample.in); });
  }

  void see_sample(const Vec3<double>& out, const BsdfSample& sample) {
    const double p = bsdf_.pdf(out, sample.in);
    density_.see(gap_between(sample.pdf, p), [&] {
      return formatted("the sample's pdf is %g, pdf(out, in) is %g at ", sample.pdf, p) + place(out, sample.in);
    });
    if (!(p > 0)) return;
    const Rgb<double> expected = bsdf_.eval(out, sample.in) * std::abs(sample.in.z()) / p;
    weight_.see(gap_between(sample.weight, expected), [&] {
      return "the sample's weight is " + text_of(sample.weight) + ", f |cos| / pdf is " + text_of(expected) +
             " at " + place(out, sample.in);
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

}  // namespace

Vec3<double> drawn_direction(double lowest, double highest, double side, const std::function<double()>& next) {
  const double z = std::min(1.0, lowest * std::pow(highest / lowest, next()));
  const double r = std::sqrt((1 - z) * (1 + z)), angle = 2 * std::numbers::pi * next();
  return {r * std::cos(angle), r * std::sin(angle), side < 0 ? -z : z};
}

std::vector<PartFinding> check_bsdf_identities(const Trial& trial, const BsdfUnderTest& bsdf,
                                               const BsdfTerms& terms) {
  Identities identities(bsdf, terms, generator_for(trial, "identities"));
  for (int i = 0; i < 16; ++i) identities.at_edges();
  for (int i = 0; i < identity_draws; ++i) identities.at_a_draw();
  std::vector<PartFinding> findings;
  for (const Identity& identity : identities.all()) findings.push_back(finding_of(trial, identity, terms.rounding));
  return findings;
}

}  // namespace fairlight
