#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <fairlight/stats/text.h>
#include <fairlight/validation/checks/bsdf_checks.h>

namespace fairlight {
namespace {

// A BSDF seen from one direction, as a sampler of directions.
DirectionsUnderTest seen(const BsdfUnderTest& bsdf, const Vec3<double>& out) {
  return {bsdf.dimensions,
          [&bsdf, out](const std::vector<double>& u) -> std::optional<DirectionSample> {
            const std::optional<BsdfSample> sample = bsdf.sample(out, u);
            if (!sample) return {};
            return DirectionSample{sample->in, sample->pdf};
          },
          [&bsdf, out](const Vec3<double>& in) { return bsdf.pdf(out, in); }};
}

Finding energy(const Trial& trial, const CellsOfDirections& cells, double rounding) {
  const CellsOfDirections::Parts& parts = cells.all().value;
  const double most = parts.tail<3>().maxCoeff();
  Finding finding{.guarantee = Guarantee::deterministic, .margin = trial.margin, .bias = most - 1};
  const bool within = most <= 1 + cells.all().error + rounding;
  finding.verdict = within ? Verdict::certified : Verdict::biased;
  finding.interval = {most - 1, most - 1};
  finding.note = formatted("f |cos| integrates to %.6f, %.6f and %.6f", parts[1], parts[2], parts[3]);
  return with_token(trial, finding);
}

Finding albedo(const Trial& trial, const BsdfUnderTest& bsdf, const BsdfTerms& terms, const Vec3<double>& out,
               Generator generator) {
  const Rgb<double> expected = terms.albedo(out);
  std::vector<Reference> references;
  for (const double mean : expected)
    references.push_back({.mean = mean, .lower = 0, .upper = terms.largest_weight, .scale = 1});
  std::vector<double> u(bsdf.dimensions);
  return test_means(trial, references, [&](std::uint64_t, std::vector<std::vector<double>>& channels) {
    for (std::size_t i = 0; i < channels[0].size(); ++i) {
      for (double& x : u) x = uniform(generator);
      const std::optional<BsdfSample> sample = bsdf.sample(out, u);
      for (std::size_t c = 0; c < 3; ++c)
        channels[c][i] = sample ? sample->weight[static_cast<Eigen::Index>(c)] : 0;
    }
  });
}

std::string seen_from(const Vec3<double>& out) {
  return formatted(" (out = (%.4f, %.4f, %.4f))", out.x(), out.y(), out.z());
}

}  // namespace

std::vector<Vec3<double>> directions_of_laws(const BsdfTerms& terms, const std::function<double()>& next) {
  std::vector<Vec3<double>> directions;
  for (const double side : {1.0, -1.0}) {
    if (side < 0 && !terms.both_sides) break;
    for (const auto& [low, high] : std::array<std::pair<double, double>, 3>{{{0.02, 0.2}, {0.2, 0.7}, {0.7, 1}}})
      directions.push_back(drawn_direction(low, high, side, next));
  }
  return directions;
}

std::vector<PartFinding> check_bsdf_laws(const Trial& trial, const BsdfUnderTest& bsdf, const BsdfTerms& terms) {
  Generator generator = generator_for(trial, "directions");
  const auto directions = directions_of_laws(terms, [&] { return uniform(generator); });
  const DirectionTerms law{.margin = terms.margin, .rounding = terms.rounding, .whole = false};
  Trial each = trial;
  each.alpha = trial.alpha / (2 * static_cast<double>(directions.size()));
  std::vector<PartFinding> findings;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Vec3<double> out = directions[i];
    const auto generator_of = [&](const char* purpose) {
      return generator_for(trial, std::string(purpose) + " " + std::to_string(i));
    };
    const std::string from = seen_from(out);
    const DirectionsUnderTest view = seen(bsdf, out);
    const CellsOfDirections cells(view, generator_of("pilot"), [&](const Vec3<double>& in) -> Rgb<double> {
      return bsdf.eval(out, in) * std::abs(in.z());
    });
    findings.push_back({"law", "samples follow the pdf" + from, cells.test(each, law, generator_of("law"))});
    if (terms.passive)
      findings.push_back(
          {"energy", "f reflects no more light than it gets" + from, energy(each, cells, terms.rounding)});
    if (terms.albedo)
      findings.push_back({"albedo", "the mean weight is the stated albedo" + from,
                          albedo(each, bsdf, terms, out, generator_of("albedo"))});
  }
  return findings;
}

std::vector<PartFinding> check_bsdf(const Trial& trial, const BsdfUnderTest& bsdf, const BsdfTerms& terms) {
  check_trial(trial);
  require_terms(bsdf.dimensions, terms.rounding);
  if (terms.albedo && !(terms.largest_weight > 0))
    throw std::invalid_argument("a stated albedo needs `largest_weight`, a bound on the weights");
  std::vector<PartFinding> findings = check_bsdf_identities(trial, bsdf, terms);
  if (!all_certified(findings)) return findings;
  for (PartFinding& more : check_bsdf_laws(trial, bsdf, terms)) findings.push_back(std::move(more));
  return findings;
}

}  // namespace fairlight
