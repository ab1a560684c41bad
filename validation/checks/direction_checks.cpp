#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fairlight/stats/seed.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/checks/identity.h>

namespace fairlight {
namespace {

class DirectionIdentities {
 public:
  DirectionIdentities(const DirectionsUnderTest& law, const DirectionTerms& terms) : law_(law), terms_(terms) {}

  void at(Identity& numbers, const std::vector<double>& u) {
    const std::optional<DirectionSample> sample = law_.sample(u);
    if (!sample) {
      if (terms_.whole) whole_.see(1, [&] { return "no direction from " + text_of(u); });
      return;
    }
    const std::string problem = problem_of(sample->direction, sample->pdf, terms_.rounding);
    if (!problem.empty())
      return numbers.see(infinity<double>, [&] { return "from " + text_of(u) + ": " + problem; });
    if (terms_.whole && sample->pdf == 0)
      whole_.see(1, [&] { return "a direction without a density from " + text_of(u); });
    const double p = law_.pdf(sample->direction);
    density_.see(gap_between(sample->pdf, p), [&] {
      return formatted("the sample's pdf is %g, that of its direction is %g, at ", sample->pdf, p) +
             text_of(sample->direction);
    });
  }

  void at_edges() {
    for_each_edge(law_.dimensions, [this](const std::vector<double>& u) { at(edges_, u); });
  }
  void at_draw(const std::vector<double>& u) { at(finite_, u); }

  std::vector<Identity> all() const {
    std::vector<Identity> those{edges_, finite_, density_};
    if (terms_.whole) those.push_back(whole_);
    return those;
  }

 private:
  const DirectionsUnderTest& law_;
  const DirectionTerms& terms_;
  Identity edges_{"edge numbers", "numbers at the edge of [0,1) give valid samples"};
  Identity finite_{"finite", "directions are unit vectors, densities finite and not negative"};
  Identity density_{"density", "a sample comes with the pdf of its direction"};
  Identity whole_{"no sample lost", "every sample has a direction with a density"};
};

std::vector<PartFinding> identities_of(const Trial& trial, const DirectionsUnderTest& law,
                                       const DirectionTerms& terms) {
  Generator generator = generator_for(trial, "identities");
  DirectionIdentities identities(law, terms);
  identities.at_edges();
  std::vector<double> u(law.dimensions);
  for (int i = 0; i < identity_draws; ++i) {
    for (double& x : u) x = uniform(generator);
    identities.at_draw(u);
  }
  std::vector<PartFinding> findings;
  for (const Identity& identity : identities.all()) findings.push_back(finding_of(trial, identity, terms.rounding));
  return findings;
}

}  // namespace

void require_terms(std::size_t dimensions, double rounding) {
  if (dimensions < 1 || dimensions > 6)
    throw std::invalid_argument("a sampler must take 1 to 6 numbers (set `dimensions` of the adapter)");
  if (!(rounding > 0 && rounding < 1))
    throw std::invalid_argument("the rounding of an identity must be in (0,1) (it is relative)");
}

bool all_certified(const std::vector<PartFinding>& findings) {
  return std::all_of(findings.begin(), findings.end(),
                     [](const PartFinding& part) { return part.finding.verdict == Verdict::certified; });
}

std::vector<PartFinding> check_directions(const Trial& trial, const DirectionsUnderTest& law,
                                          const DirectionTerms& terms) {
  check_trial(trial);
  require_terms(law.dimensions, terms.rounding);
  std::vector<PartFinding> findings = identities_of(trial, law, terms);
  if (!all_certified(findings)) return findings;
  const CellsOfDirections cells(law, generator_for(trial, "pilot"),
                                [](const Vec3<double>&) { return zero<Rgb<double>>(); });
  findings.push_back({"law", "samples follow the pdf", cells.test(trial, terms, generator_for(trial, "law"))});
  return findings;
}

Expectation expectation_of(const Site& site, const Trial& trial, const std::vector<PartFinding>& findings) {
  std::string message;
  for (const auto& [check, statement, finding] : findings) {
    if (finding.verdict == Verdict::certified) continue;
    message += formatted("%s: %s: that %s\n", name(finding.verdict), check.c_str(), statement.c_str());
    message += formatted("  %s\n", finding.note.c_str());
  }
  const bool met = message.empty();
  message += formatted("  %zu checks, level %.1e, miss rate %.0e\n", findings.size(), trial.alpha, trial.beta);
  message += "  again: FAIRLIGHT_SEED=" + seed_text(trial.seed) + " " + site.replay + "\n";
  return {met, message};
}

}  // namespace fairlight
