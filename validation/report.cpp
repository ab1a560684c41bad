#include <algorithm>

#include <fairlight/stats/seed.h>
#include <fairlight/validation/report.h>
#include <fairlight/version.h>

namespace fairlight {
namespace {

int rank(Verdict verdict) { return verdict == Verdict::biased ? 0 : verdict == Verdict::undecided ? 1 : 2; }

std::vector<Outcome> worst_first(std::vector<Outcome> outcomes) {
  std::stable_sort(outcomes.begin(), outcomes.end(), [](const Outcome& a, const Outcome& b) {
    return rank(a.finding.verdict) < rank(b.finding.verdict);
  });
  return outcomes;
}

std::string text(const char* format, auto... values) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, values...);
  return buffer;
}

}  // namespace

std::string replay(const std::string& claim, const Conformance& conformance) {
  std::string command = "fairlight verify " + claim + " --seed " + seed_text(conformance.terms.seed);
  const Conformance usual{{.seed = 0}};
  if (conformance.terms.margin != usual.terms.margin) command += text(" --margin %.17g", conformance.terms.margin);
  if (conformance.terms.budget != usual.terms.budget) command += text(" --budget %.17g", conformance.terms.budget);
  return command;
}

void print_outcomes(std::FILE* out, const std::vector<Outcome>& outcomes, const Conformance& conformance) {
  std::fprintf(out, "%-34s %-10s %-14s %9s %22s %12s %7s\n", "claim", "verdict", "guarantee", "margin",
               "bias between", "draws", "seconds");
  for (const auto& [claim, finding, seconds, evidence] : worst_first(outcomes)) {
    const std::string interval = text("%+.2e", finding.interval.lo) + " " + text("%+.2e", finding.interval.hi);
    std::fprintf(out, "%-34s %-10s %-14s %9.1e %22s %12llu %7.2f\n", claim->name.c_str(), name(finding.verdict),
                 name(finding.guarantee), finding.margin, interval.c_str(),
                 static_cast<unsigned long long>(finding.draws), seconds);
    if (!finding.note.empty()) std::fprintf(out, "    %s\n", finding.note.c_str());
    if (finding.verdict != Verdict::certified) {
      std::fprintf(out, "    %s: %s\n    again: %s\n", claim->kind.c_str(), claim->statement.c_str(),
                   replay(claim->name, conformance).c_str());
    }
  }
}

nlohmann::json outcomes_json(const std::vector<Outcome>& outcomes, const Conformance& conformance, double seconds) {
  nlohmann::json claims = nlohmann::json::array();
  for (const auto& [claim, finding, claim_seconds, evidence] : outcomes) {
    claims.push_back({{"name", claim->name},
                      {"kind", claim->kind},
                      {"verdict", name(finding.verdict)},
                      {"guarantee", name(finding.guarantee)},
                      {"margin", finding.margin},
                      {"bias", finding.bias},
                      {"interval", {finding.interval.lo, finding.interval.hi}},
                      {"samples", finding.draws},
                      {"seconds", claim_seconds},
                      {"real", claim->real},
                      {"rounding", finding.rounding},
                      {"note", finding.note},
                      {"replay", replay(claim->name, conformance)}});
  }
  return {{"version", version}, {"seed", seed_text(conformance.terms.seed)}, {"budget", conformance.terms.budget},
          {"seconds", seconds}, {"verdict", name(overall(outcomes))},        {"claims", claims}};
}

}  // namespace fairlight
