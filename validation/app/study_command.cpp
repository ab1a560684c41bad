#include <cstdio>
#include <memory>

#include <fairlight/stats/seed.h>
#include <fairlight/validation/app/commands.h>
#include <fairlight/validation/app/options.h>
#include <fairlight/validation/app/progress.h>
#include <fairlight/validation/studies/run_studies.h>
#include <fairlight/validation/studies/study_page.h>

namespace fairlight {
namespace {

struct StudyCommandOptions {
  std::vector<std::string> names;
  std::string folder, seed;
  bool quick = false;
  int threads = hardware_threads();
};

std::string names_help() {
  std::string help = "Run these studies, or all.";
  for (const Study& study : studies()) help += std::string("\n") + study.name + ": " + study.title + ".";
  return help;
}

int run(const StudyCommandOptions& options) {
  StudyRun studies{.names = options.names,
                   .options = {.folder = options.folder,
                               .quick = options.quick,
                               .threads = options.threads,
                               .progress = progress_bar("study")},
                   .seed = {}};
  if (!options.seed.empty()) studies.seed = parse_seed(options.seed);
  run_studies(studies, [&](const nlohmann::json& study, bool fresh) {
    const auto name = study.at("study").get<std::string>(), seed = study.at("seed").get<std::string>();
    std::fputs(study_text(study).c_str(), stdout);
    std::printf("\nseed %s: %s/%s.md%s\n\n", seed.c_str(), options.folder.c_str(), name.c_str(),
                fresh ? "" : " (done by an earlier run)");
    std::fflush(stdout);
  });
  return 0;
}

}  // namespace

void add_study_command(CLI::App& program, Command& command) {
  auto* app = program.add_subcommand("study", "Measure the paper's experiments again, with error bars.");
  auto options = std::make_shared<StudyCommandOptions>();
  begin_group(*app, "Studies");
  app->add_option("studies", options->names, names_help())->required()->type_name("NAME");
  app->add_flag("--quick", options->quick, "Take few samples and small pictures, for a look.");
  add_text(*app, "--seed", options->seed, "HEX",
           "Draw random numbers from this seed, 1 to 16 hexadecimal digits. Without it, an unfinished run in the "
           "folder goes on with its own, and any other takes a fresh one.");
  begin_group(*app, "Files");
  add_text(*app, "--out", options->folder, "DIR",
           "Write pages, tables and pictures to this folder. What is finished when a run is killed stays, and the "
           "same command goes on from there.")
      ->required();
  add_threads(*app, options->threads);
  add_examples(*app, {"fairlight study fig2 --quick --out studies", "fairlight study all --out studies"});
  app->callback([options, &command] { command = [options] { return run(*options); }; });
}

}  // namespace fairlight
