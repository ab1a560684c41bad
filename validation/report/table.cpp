#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>

#include <unistd.h>

#include <fairlight/validation/report/report.h>

namespace fairlight {
namespace {

// Claims that have not failed are grouped if there are more than this.
constexpr std::size_t many = 40;

// The outcomes of one row: a single one, or those whose claims share the first part of their name.
using Group = std::vector<const Outcome*>;

std::string first_name(const Outcome& outcome) {
  return outcome.claim->name.substr(0, outcome.claim->name.find('.'));
}

std::string title(const Group& group, const RunOptions& run_options) {
  if (group.size() == 1) return label(*group[0], run_options);
  return first_name(*group[0]) + " (" + std::to_string(group.size()) + ")";
}

std::vector<Group> grouped(const std::vector<Outcome>& outcomes, Rows rows) {
  const auto quiet = std::ranges::count_if(outcomes, [](const Outcome& o) { return !failed(o); });
  const bool merge = rows == Rows::grouped && static_cast<std::size_t>(quiet) > many;
  std::vector<Group> groups;
  std::map<std::pair<Verdict, std::string>, std::size_t> places;
  for (const Outcome& outcome : outcomes) {
    const auto key = std::pair(outcome.finding.verdict, first_name(outcome));
    if (!merge || failed(outcome) || !places.contains(key)) {
      if (!failed(outcome)) places[key] = groups.size();
      groups.push_back({&outcome});
    } else {
      groups[places[key]].push_back(&outcome);
    }
  }
  return groups;
}

// Whether this end of the interval bounds the bias. For a certified one-sided claim, the end on the
// side that the claim does not exclude is infinite.
bool bounds(const Outcome& outcome, double end) {
  return outcome.finding.verdict != Verdict::certified || std::isfinite(end);
}

// The smallest interval that holds those of all outcomes. An end is open only if it is open for
// every claim.
Interval interval_of(const Group& group) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Interval all{infinite, -infinite};
  for (const Outcome* outcome : group) {
    const Interval& one = outcome->finding.interval;
    if (bounds(*outcome, one.lo)) all.lo = std::min(all.lo, one.lo);
    if (bounds(*outcome, one.hi)) all.hi = std::max(all.hi, one.hi);
  }
  return all;
}

// The finding of a row: the widest margin and interval, the sum of the draws.
Finding finding_of(const Group& group) {
  Finding all = group[0]->finding;
  all.interval = interval_of(group);
  for (const Outcome* outcome : group) {
    all.margin = std::max(all.margin, outcome->finding.margin);
    if (outcome != group[0]) all.draws += outcome->finding.draws;
  }
  return all;
}

std::string guarantee_of(const Group& group) {
  const auto same = [&](const Outcome* o) { return o->finding.guarantee == group[0]->finding.guarantee; };
  return std::ranges::all_of(group, same) ? name(group[0]->finding.guarantee) : "mixed";
}

class Table {
 public:
  Table(std::FILE* out, const std::vector<Group>& groups, const RunOptions& run_options)
      : out_(out), options_(run_options) {
    colours_ = isatty(fileno(out)) != 0 && std::getenv("NO_COLOR") == nullptr;
    for (const Group& group : groups) width_ = std::max(width_, static_cast<int>(title(group, run_options).size()));
    std::fprintf(out_, "%-*s %-10s %-21s %8s %21s %12s %8s\n", width_, "claim", "verdict", "guarantee", "margin",
                 "bias between", "draws", "seconds");
  }

  void row(const Group& group) const {
    const Finding finding = finding_of(group);
    double seconds = 0;
    for (const Outcome* outcome : group) seconds += outcome->seconds;
    std::fprintf(out_, "%-*s %s%-10s%s %-21s %8.1e %10s %10s %12llu %8.2f\n", width_,
                 title(group, options_).c_str(), colour(finding.verdict), name(finding.verdict),
                 colours_ ? "\033[0m" : "", guarantee_of(group).c_str(), finding.margin,
                 end_text(finding.interval.lo).c_str(), end_text(finding.interval.hi).c_str(),
                 static_cast<unsigned long long>(finding.draws), seconds);
  }

 private:
  const char* colour(Verdict verdict) const {
    if (!colours_) return "";
    return verdict == Verdict::biased ? "\033[1;31m" : verdict == Verdict::undecided ? "\033[33m" : "\033[32m";
  }

  std::FILE* out_;
  const RunOptions& options_;
  bool colours_;
  int width_ = 34;
};

void print_why(std::FILE* out, const Outcome& outcome, const RunOptions& run_options) {
  if (!outcome.finding.note.empty()) std::fprintf(out, "    %s\n", outcome.finding.note.c_str());
  if (!failed(outcome)) return;
  std::fprintf(out, "    %s: %s\n    again: %s\n", outcome.claim->kind.c_str(), outcome.claim->statement.c_str(),
               replay(*outcome.claim, run_options).c_str());
}

// Prints each note of the grouped rows once, with the names of its claims.
void print_notes(std::FILE* out, const std::vector<Group>& groups, const RunOptions& run_options) {
  constexpr std::size_t most_names = 3;
  std::map<std::string, std::vector<std::string>> claims;  // by note
  for (const Group& group : groups) {
    if (group.size() == 1) continue;
    for (const Outcome* outcome : group) claims[outcome->finding.note].push_back(label(*outcome, run_options));
  }
  for (const auto& [note, names] : claims) {
    if (!note.empty()) std::fprintf(out, "%s: %s\n", list_of(names, most_names).c_str(), note.c_str());
  }
}

}  // namespace

void print_outcomes(std::FILE* out, const std::vector<Outcome>& outcomes, const RunOptions& run_options,
                    Rows rows) {
  const std::vector<Outcome> sorted = worst_first(outcomes);
  const std::vector<Group> groups = grouped(sorted, rows);
  const Table table(out, groups, run_options);
  for (const Group& group : groups) {
    table.row(group);
    if (group.size() == 1) print_why(out, *group[0], run_options);
  }
  print_notes(out, groups, run_options);
}

void print_components(std::FILE* out, const std::vector<ComponentOutcome>& components,
                      const RunOptions& run_options) {
  if (components.empty()) return;
  std::vector<ComponentOutcome> sorted = components;
  std::ranges::stable_sort(sorted, {}, [](const ComponentOutcome& c) { return rank(c.verdict); });
  const auto title = [&](const ComponentOutcome& c) {
    return run_options.instructions.size() == 1 ? c.name : c.name + " [" + c.instructions + "]";
  };
  std::size_t width = 34;
  for (const ComponentOutcome& c : sorted) width = std::max(width, title(c).size());
  std::fprintf(out, "%-*s %6s  %-10s %s\n", static_cast<int>(width), "component", "claims", "verdict",
               "relative bias common to its claims");
  for (const ComponentOutcome& c : sorted)
    std::fprintf(out, "%-*s %6zu  %-10s %s\n", static_cast<int>(width), title(c).c_str(), c.claims, name(c.verdict),
                 common_bias_text(c).c_str());
}

}  // namespace fairlight
