#include <fstream>
#include <stdexcept>

#include <fairlight/render/atomic_file.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/audit/mutation_results.h>

namespace fairlight {
namespace {

double percent(std::size_t part, std::size_t all) {
  return all == 0 ? 100.0 : 100.0 * static_cast<double>(part) / static_cast<double>(all);
}

void count(MutationCounts& counts, Fate::Kind kind) {
  switch (kind) {
    case Fate::Kind::killed:
      ++counts.killed_by_claims;
      return;
    case Fate::Kind::killed_by_tests:
      ++counts.killed_by_tests;
      return;
    case Fate::Kind::survived:
      ++counts.survived;
      return;
    case Fate::Kind::equivalent:
      ++counts.equivalent;
      return;
    case Fate::Kind::no_program:
      ++counts.no_program;
      return;
  }
}

nlohmann::json json_of(const MutationCounts& counts) {
  return {{"mutants", counts.killed() + counts.survived + counts.equivalent + counts.no_program},
          {"killed", counts.killed()},
          {"killed_by_claims", counts.killed_by_claims},
          {"killed_by_tests_only", counts.killed_by_tests},
          {"survived", counts.survived},
          {"equivalent", counts.equivalent},
          {"no_program", counts.no_program}};
}

}  // namespace

MutationResults::MutationResults(const std::string& path) : path_(path) {
  if (!path.empty()) AtomicFile::check_writable(path);
  std::ifstream lines(path);
  for (std::string line; std::getline(lines, line);) {
    const auto json = nlohmann::json::parse(line, nullptr, false);
    try {
      fates_[json.at("mutant")] = {fate_named(json.at("fate")), json.at("by"), json.at("seconds")};
    } catch (const std::exception&) {
      throw std::runtime_error("\"" + path + "\" does not hold results of a mutation run (give another file)");
    }
  }
}

bool MutationResults::knows(const Mutant& mutant) const {
  const std::lock_guard lock(mutex_);
  return fates_.contains(mutant.name());
}

void MutationResults::add(const Mutant& mutant, const Fate& fate) {
  const std::lock_guard lock(mutex_);
  fates_[mutant.name()] = fate;
  if (path_.empty()) return;
  std::ofstream out(path_, std::ios::app);
  out << nlohmann::json({{"mutant", mutant.name()},
                         {"kind", mutant.kind},
                         {"fate", name(fate.kind)},
                         {"by", fate.by},
                         {"seconds", fate.seconds}})
             .dump()
      << std::endl;
  if (!out) throw std::runtime_error("cannot write \"" + path_ + "\" (is the disk full?)");
}

double MutationCounts::percent_killed() const { return percent(killed(), killed() + survived); }
double MutationCounts::percent_killed_by_claims() const { return percent(killed_by_claims, killed() + survived); }

MutationCounts counts_of(const std::vector<Mutant>& mutants, const MutationResults& results) {
  MutationCounts counts;
  for (const Mutant& mutant : mutants) count(counts, results.fate(mutant).kind);
  return counts;
}

std::string summary(const MutationCounts& counts) {
  const std::size_t alive = counts.killed() + counts.survived;
  return formatted(
      "%zu of %zu mutants killed (%.1f %%): %zu by claims (%.1f %%), %zu by tests only; %zu more are equivalent, "
      "%zu "
      "do not compile",
      counts.killed(), alive, counts.percent_killed(), counts.killed_by_claims, counts.percent_killed_by_claims(),
      counts.killed_by_tests, counts.equivalent, counts.no_program);
}

std::string mutation_page(const std::vector<Mutant>& mutants, const MutationResults& results,
                          const std::string& command) {
  std::string page =
      "# Mutants that no claim noticed\n\n`" + command + "`: " + summary(counts_of(mutants, results)) + ".\n";
  for (const Mutant& m : mutants) {
    const Fate& fate = results.fate(m);
    const bool survived = fate.kind == Fate::Kind::survived;
    if (!survived && fate.kind != Fate::Kind::killed_by_tests) continue;
    page += formatted("\n`%s`, line %d (%s), noticed by %s%s:\n\n```\n-%s\n+%s\n```\n", m.file.c_str(), m.line,
                      m.kind.c_str(), survived ? "nothing in " : "", fate.by.c_str(), m.before.c_str(),
                      m.after.c_str());
  }
  return page;
}

nlohmann::json mutation_json(const std::vector<Mutant>& mutants, const MutationResults& results,
                             const std::string& seed) {
  nlohmann::json json = json_of(counts_of(mutants, results));
  json["seed"] = seed;
  std::map<std::string, MutationCounts> kinds;
  nlohmann::json survivors = nlohmann::json::array(), tests_only = nlohmann::json::array();
  for (const Mutant& m : mutants) {
    const Fate& fate = results.fate(m);
    count(kinds[m.kind], fate.kind);
    const nlohmann::json row = {{"file", m.file},     {"line", m.line},   {"kind", m.kind},
                                {"before", m.before}, {"after", m.after}, {"by", fate.by}};
    if (fate.kind == Fate::Kind::survived) survivors.push_back(row);
    if (fate.kind == Fate::Kind::killed_by_tests) tests_only.push_back(row);
  }
  for (const auto& [kind, counts] : kinds) json["kinds"][kind] = json_of(counts);
  json["survivors"] = survivors;
  json["tests_only"] = tests_only;
  return json;
}

}  // namespace fairlight
