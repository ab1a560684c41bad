#include <algorithm>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include <fairlight/render/atomic_file.h>
#include <fairlight/render/nearest_names.h>
#include <fairlight/render/parallel.h>
#include <fairlight/stats/seed.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/app/commands.h>
#include <fairlight/validation/app/options.h>
#include <fairlight/validation/app/progress.h>
#include <fairlight/validation/audit/known_equivalents.h>
#include <fairlight/validation/audit/mutation_results.h>
#include <fairlight/validation/run/registry.h>

namespace fairlight {
namespace {

namespace fs = std::filesystem;

struct MutateOptions {
  std::string seed, results, report, json, operators = "all";
  std::vector<std::string> sources;
  std::size_t sample = 100;
  MutationLimits limits;
  int threads = hardware_threads();
};

// The sources of a folder, or of all that are mutated.
std::vector<std::string> sources_in(const std::string& root, const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(root + "/" + folder)) {
    const std::string type = entry.path().extension().string();
    if (type == ".h" || type == ".cpp") files.push_back(folder + "/" + entry.path().filename().string());
  }
  std::ranges::sort(files);
  return files;
}

// The files that are asked for, by name or by folder. If none are, those that claims rest on: no
// claim can notice a change of others, such as those that write pictures.
std::vector<std::string> chosen_sources(const BuildPlaces& places, const std::vector<std::string>& only) {
  constexpr const char* folders[] = {"estimators", "render", "stats"};
  std::vector<std::string> names, files;
  for (const std::string folder : folders) {
    for (const std::string& file : sources_in(places.source, folder)) files.push_back(file);
    names.push_back(folder);
  }
  std::ranges::copy(files, std::back_inserter(names));
  std::vector<std::string> chosen;
  for (std::string name : only) {
    if (name.ends_with('/')) name.pop_back();
    if (std::ranges::find(names, name) == names.end())
      throw std::invalid_argument("\"" + name + "\" is not mutated " +
                                  did_you_mean(name, names, "fairlight audit mutate --help"));
    std::ranges::copy_if(files, std::back_inserter(chosen),
                         [&](const std::string& file) { return file == name || file.starts_with(name + "/"); });
  }
  if (!only.empty()) return chosen;
  Sources sources(places);
  std::set<std::string> rested_on;
  for (const Claim& claim : registry()) rested_on.merge(std::set<std::string>(sources.files_of(claim.file)));
  std::ranges::copy_if(files, std::back_inserter(chosen),
                       [&](const std::string& file) { return rested_on.contains(file); });
  return chosen;
}

std::vector<Mutant> all_mutants(const BuildPlaces& places, const MutateOptions& options) {
  std::vector<Mutant> mutants;
  const Operators operators = operators_named(options.operators);
  for (const std::string& file : chosen_sources(places, options.sources)) {
    for (Mutant& m : mutants_of(file, read_whole(places.source + "/" + file), operators))
      mutants.push_back(std::move(m));
  }
  return mutants;
}

void run_mutants(const std::vector<Mutant>& mutants, const MutateOptions& options, MutationResults& results) {
  MutationRun run(this_build(), options.limits);
  const Progress progress = progress_bar("audit mutate");
  std::atomic<int> done = 0;
  const auto n = static_cast<int>(mutants.size());
  for_each_unit(n, options.threads, [&](int i) {
    const Mutant& mutant = mutants[static_cast<std::size_t>(i)];
    const std::string why = known_equivalence(mutant);
    if (!why.empty()) results.add(mutant, {Fate::Kind::equivalent, why});
    if (!results.knows(mutant)) results.add(mutant, run.judge(mutant));
    const int so_far = ++done;
    if (progress) progress(static_cast<double>(so_far) / n);
  });
}

std::string command_of(const MutateOptions& options, const std::string& seed) {
  std::string command = "fairlight audit mutate";
  for (const std::string& source : options.sources) command += formatted(" %s", source.c_str());
  return command + formatted(" --operators %s --sample %zu --seed %s --files %zu --seconds %g",
                             options.operators.c_str(), options.sample, seed.c_str(), options.limits.files,
                             options.limits.seconds);
}

int mutate(const MutateOptions& options) {
  for (const std::string& file : {options.report, options.json}) {
    if (!file.empty()) AtomicFile::check_writable(file);
  }
  const std::string seed = options.seed.empty() ? seed_text(fresh_seed()) : options.seed;
  const std::uint64_t number = parse_seed(seed);
  MutationResults results(options.results);
  const std::vector<Mutant> all = all_mutants(this_build(), options);
  std::vector<Mutant> mutants = sample_of(all, options.sample, number);
  std::fprintf(stderr, "a sample of %zu of %zu mutants, seed %s\n", mutants.size(), all.size(), seed.c_str());
  run_mutants(mutants, options, results);
  std::ranges::sort(mutants, {}, [](const Mutant& m) { return std::pair(m.file, m.begin); });
  for (const Mutant& m : mutants) {
    const Fate& fate = results.fate(m);
    std::printf("%-15s %-11s %6.1f s  %s\n    %s\n", name(fate.kind), m.kind.c_str(), fate.seconds,
                m.name().c_str(), fate.by.c_str());
  }
  const MutationCounts counts = counts_of(mutants, results);
  std::printf("%s (a sample of %zu mutants, seed %s)\n", summary(counts).c_str(), all.size(), seed.c_str());
  if (!options.report.empty())
    write_whole(options.report, mutation_page(mutants, results, command_of(options, seed)));
  if (!options.json.empty()) write_whole(options.json, mutation_json(mutants, results, seed).dump(2) + "\n");
  return counts.percent_killed() >= 95 ? 0 : 1;
}

void add_choice_of_mutants(CLI::App& app, MutateOptions& options) {
  begin_group(app, "Mutants");
  app.add_option("sources", options.sources,
                 "Change these files or folders, for example estimators/cone.h or render. All files of estimators, "
                 "render and stats that claims rest on if none is given.")
      ->type_name("FILE");
  add_choice(app, "--operators", options.operators, {"slips", "meaning", "all"},
             "Make slips of the pen, such as + for -, errors of meaning, such as a clamp, or all.")
      ->capture_default_str();
  add_count(app, "--sample", options.sample, std::size_t{1}, std::size_t{100000},
            "Take this many mutants at random; each takes half a minute.")
      ->capture_default_str();
  add_text(app, "--seed", options.seed, "HEX",
           "Take the same mutants as a run that printed this seed, 16 hexadecimal digits. Fresh if not given.");
  begin_group(app, "How much to run");
  add_count(app, "--files", options.limits.files, std::size_t{1}, std::size_t{100},
            "Compile at most this many files of claims for a mutant, those with most of its code first.")
      ->capture_default_str();
  add_number(app, "--seconds", options.limits.seconds, {.low = 0},
             "Begin no further file of claims for a mutant after this many seconds.")
      ->capture_default_str();
}

}  // namespace

void add_mutate_command(CLI::App& audit, Command& command) {
  auto* app = audit.add_subcommand(
      "mutate", "Make one error at a time in the sources, of the pen or of meaning: the claims must notice.");
  auto options = std::make_shared<MutateOptions>();
  add_choice_of_mutants(*app, *options);
  begin_group(*app, "Files");
  add_text(*app, "--results", options->results, "F.jsonl",
           "Keep what becomes of each mutant in this file; a run that was stopped goes on, given the same seed.");
  add_text(*app, "--report", options->report, "F.md",
           "Write a page of the mutants that no claim noticed to this file.");
  add_text(*app, "--json", options->json, "F.json", "Write counts, survivors and mutants that only tests noticed.");
  add_threads(*app, options->threads, "Work on this many mutants at once.");
  add_examples(*app, {"fairlight audit mutate estimators/cone.h --sample 20",
                      "fairlight audit mutate --operators meaning --json mutants.json",
                      "fairlight audit mutate --seed 0123456789abcdef --results mutants.jsonl"});
  app->callback([options, &command] { command = [options] { return mutate(*options); }; });
}

}  // namespace fairlight
