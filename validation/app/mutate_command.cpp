#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include <fairlight/render/atomic_file.h>
#include <fairlight/render/nearest_names.h>
#include <fairlight/render/parallel.h>
#include <fairlight/stats/seed.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/app/commands.h>
#include <fairlight/validation/app/options.h>
#include <fairlight/validation/app/progress.h>
#include <fairlight/validation/audit/known_equivalents.h>
#include <fairlight/validation/audit/mutation_run.h>

namespace fairlight {
namespace {

namespace fs = std::filesystem;

struct MutateOptions {
  std::string seed, results, report;
  std::vector<std::string> sources;
  std::size_t sample = 100, files = 3;
  int threads = hardware_threads();
};

// The files of the path tracer to mutate. With all of estimators/, they are the subjects of the
// claims.
constexpr std::array tracer{"camera",    "direct_light", "geometry",     "light_table", "path_tracer",
                            "rectangle", "sphere",       "surface_bsdf", "traced_scene"};

std::vector<std::string> mutable_sources(const std::string& root) {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(root + "/estimators")) {
    if (entry.path().extension() == ".h") files.push_back("estimators/" + entry.path().filename().string());
  }
  for (const char* stem : tracer) files.push_back(std::string("render/") + stem + ".h");
  std::ranges::sort(files);
  return files;
}

std::vector<Mutant> all_mutants(const std::string& root, const std::vector<std::string>& only) {
  const std::vector<std::string> files = mutable_sources(root);
  for (const std::string& file : only) {
    if (std::ranges::find(files, file) == files.end())
      throw std::invalid_argument("\"" + file + "\" is not mutated " +
                                  did_you_mean(file, files, "fairlight audit mutate --help"));
  }
  std::vector<Mutant> mutants;
  for (const std::string& file : only.empty() ? files : only) {
    for (Mutant& m : mutants_of(file, read_whole(root + "/" + file))) mutants.push_back(std::move(m));
  }
  return mutants;
}

// The fates of mutants, one line of JSON for each, so that a run that was stopped can continue.
class Results {
 public:
  explicit Results(const std::string& path) : path_(path) {
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

  bool knows(const Mutant& mutant) const { return fates_.contains(mutant.name()); }
  const Fate& fate(const Mutant& mutant) const { return fates_.at(mutant.name()); }

  void add(const Mutant& mutant, const Fate& fate) {
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

 private:
  std::string path_;
  std::map<std::string, Fate> fates_;
  std::mutex mutex_;
};

void run_mutants(const std::vector<Mutant>& mutants, const MutateOptions& options, Results& results) {
  MutationRun run(this_build());
  const Progress progress = progress_bar("audit mutate");
  std::atomic<int> done = 0;
  const auto n = static_cast<int>(mutants.size());
  for_each_unit(n, options.threads, [&](int i) {
    const Mutant& mutant = mutants[static_cast<std::size_t>(i)];
    const std::string why = known_equivalence(mutant);
    if (!why.empty()) results.add(mutant, {Fate::Kind::equivalent, why});
    if (!results.knows(mutant)) results.add(mutant, run.judge(mutant, options.files));
    const int so_far = ++done;
    if (progress) progress(static_cast<double>(so_far) / n);
  });
}

std::size_t count(const std::vector<Mutant>& mutants, const Results& results, Fate::Kind kind) {
  return static_cast<std::size_t>(
      std::ranges::count_if(mutants, [&](const Mutant& m) { return results.fate(m).kind == kind; }));
}

std::string summary(const std::vector<Mutant>& mutants, const Results& results) {
  const std::size_t killed = count(mutants, results, Fate::Kind::killed);
  const std::size_t alive = killed + count(mutants, results, Fate::Kind::survived);
  return formatted("%zu of %zu mutants killed (%.1f %%); %zu more are equivalent, %zu do not compile", killed,
                   alive, alive == 0 ? 100.0 : 100.0 * static_cast<double>(killed) / static_cast<double>(alive),
                   count(mutants, results, Fate::Kind::equivalent),
                   count(mutants, results, Fate::Kind::no_program));
}

std::string report(const std::vector<Mutant>& mutants, const Results& results, const std::string& command) {
  std::string page = "# Mutants that survived\n\n`" + command + "`: " + summary(mutants, results) + ".\n";
  for (const Mutant& m : mutants) {
    if (results.fate(m).kind != Fate::Kind::survived) continue;
    page += formatted("\n`%s`, line %d, noticed by nothing in %s:\n\n```\n-%s\n+%s\n```\n", m.file.c_str(), m.line,
                      results.fate(m).by.c_str(), m.before.c_str(), m.after.c_str());
  }
  return page;
}

int mutate(const MutateOptions& options) {
  if (!options.report.empty()) AtomicFile::check_writable(options.report);
  const std::string seed = options.seed.empty() ? seed_text(fresh_seed()) : options.seed;
  const std::vector<Mutant> all = all_mutants(this_build().source, options.sources);
  std::vector<Mutant> mutants = sample_of(all, options.sample, parse_seed(seed));
  Results results(options.results);
  std::fprintf(stderr, "a sample of %zu of %zu mutants, seed %s\n", mutants.size(), all.size(), seed.c_str());
  run_mutants(mutants, options, results);
  std::ranges::sort(mutants, {}, [](const Mutant& m) { return std::pair(m.file, m.begin); });
  for (const Mutant& m : mutants) {
    const Fate& fate = results.fate(m);
    std::printf("%-10s %-8s %6.1f s  %s\n    %s\n", name(fate.kind), m.kind.c_str(), fate.seconds, m.name().c_str(),
                fate.by.c_str());
  }
  std::printf("%s (a sample of %zu mutants, seed %s)\n", summary(mutants, results).c_str(), all.size(),
              seed.c_str());
  std::string command = "fairlight audit mutate";
  for (const std::string& source : options.sources) command += formatted(" %s", source.c_str());
  command += formatted(" --sample %zu --seed %s --files %zu", options.sample, seed.c_str(), options.files);
  if (!options.report.empty()) write_whole(options.report, report(mutants, results, command));
  const std::size_t survived = count(mutants, results, Fate::Kind::survived);
  const bool kept =
      20 * survived <= survived + count(mutants, results, Fate::Kind::killed);  // at least 95 % killed
  return kept ? 0 : 1;
}

}  // namespace

void add_mutate_command(CLI::App& audit, Command& command) {
  auto* app = audit.add_subcommand(
      "mutate", "Change one operator, constant, cosine or sign of the sources at a time: the claims must notice.");
  auto options = std::make_shared<MutateOptions>();
  begin_group(*app, "Mutants");
  app->add_option("sources", options->sources,
                  "Change these headers, for example estimators/cone.h. All of estimators/ and the path tracer if "
                  "none is given.")
      ->type_name("FILE");
  add_count(*app, "--sample", options->sample, std::size_t{1}, std::size_t{100000},
            "Take this many mutants at random; each takes half a minute.")
      ->capture_default_str();
  add_text(*app, "--seed", options->seed, "HEX",
           "Take the same mutants as a run that printed this seed, 16 hexadecimal digits. Fresh if not given.");
  add_count(*app, "--files", options->files, std::size_t{1}, std::size_t{100},
            "Run the claims of at most this many files for a mutant, those most concerned first.")
      ->capture_default_str();
  begin_group(*app, "Files");
  add_text(*app, "--results", options->results, "F.jsonl",
           "Keep what becomes of each mutant in this file; a run that was stopped goes on, given the same seed.");
  add_text(*app, "--report", options->report, "F.md", "Write a page of the mutants that survived to this file.");
  add_threads(*app, options->threads, "Work on this many mutants at once.");
  add_examples(*app, {"fairlight audit mutate estimators/cone.h --sample 20",
                      "fairlight audit mutate --seed 0123456789abcdef --results mutants.jsonl"});
  app->callback([options, &command] { command = [options] { return mutate(*options); }; });
}

}  // namespace fairlight
