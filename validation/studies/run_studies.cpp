#include <algorithm>
#include <filesystem>
#include <numeric>
#include <stdexcept>

#include <fairlight/render/atomic_file.h>
#include <fairlight/render/file_lock.h>
#include <fairlight/stats/seed.h>
#include <fairlight/validation/report/charts.h>
#include <fairlight/validation/run/replay_token.h>
#include <fairlight/validation/studies/run_studies.h>
#include <fairlight/validation/studies/study_page.h>

namespace fairlight {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::vector<const Study*> chosen(const std::vector<std::string>& names) {
  std::vector<const Study*> found;
  const auto add = [&](const Study& study) {
    if (std::ranges::find(found, &study) == found.end()) found.push_back(&study);
  };
  for (const std::string& name : names) {
    if (name == "all") {
      for (const Study& study : studies()) add(study);
    } else {
      add(study_named(name));
    }
  }
  return found;
}

void make_folder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw std::runtime_error("cannot make the folder \"" + folder + "\" (" + error.message() + ")");
}

// What an unfinished run is continued by: the same studies in the same way, by the same program.
json identity(const StudyRun& run, const std::vector<const Study*>& list) {
  json names = json::array();
  for (const Study* study : list) names.push_back(study->name);
  return {{"studies", names}, {"quick", run.options.quick}, {"program", replay_token(0)}};
}

// The seed of an unfinished run that this one continues; empty if there is none.
std::optional<std::uint64_t> unfinished_seed(const std::string& path, const json& identity) {
  if (!fs::exists(path)) return {};
  const json left = json::parse(read_whole(path), nullptr, false);
  if (!left.is_object() || left.value("run", json()) != identity || !left.value("seed", json()).is_string())
    return {};
  return parse_seed(left.at("seed").get<std::string>());
}

std::string index_of(const std::vector<json>& pages) {
  std::string out =
      "# Studies\n\nThe experiments of the paper, measured again by `fairlight study`. Values in brackets "
      "are 95 % confidence intervals.\n\n| study | of | |\n|---|---|---|\n";
  for (const json& page : pages) {
    const auto text = [&](const char* key) { return page.at(key).get<std::string>(); };
    out +=
        "| [" + text("study") + "](" + text("study") + ".md) | " + text("source") + " | " + text("title") + " |\n";
  }
  return out;
}

}  // namespace

void run_studies(StudyRun run, const std::function<void(const json&, bool fresh)>& show) {
  const std::vector<const Study*> list = chosen(run.names);
  const std::string folder = run.options.folder, marker = folder + "/unfinished.json";
  check_gnuplot();
  make_folder(folder);
  AtomicFile::check_writable(marker);
  const OutputLock lock(marker);
  const json same = identity(run, list);
  const std::optional<std::uint64_t> left = unfinished_seed(marker, same);
  const bool goes_on = left && (!run.seed || *run.seed == *left);
  run.options.seed = goes_on ? *left : run.seed ? *run.seed : fresh_seed();
  std::vector<std::string> done;
  if (goes_on) done = json::parse(read_whole(marker)).at("done").get<std::vector<std::string>>();
  const auto mark = [&] {
    write_json(marker, {{"run", same}, {"seed", seed_text(run.options.seed)}, {"done", done}});
  };
  mark();

  const double all =
      std::accumulate(list.begin(), list.end(), 0.0, [](double sum, auto* s) { return sum + s->seconds; });
  double before = 0;
  std::vector<json> pages;
  for (const Study* study : list) {
    const std::string file = folder + "/" + study->name + ".json";
    const bool fresh = std::ranges::find(done, study->name) == done.end() || !fs::exists(file);
    if (fresh) {
      StudyOptions options = run.options;
      options.progress = [&](double part) {
        if (run.options.progress) run.options.progress((before + part * study->seconds) / all);
      };
      pages.push_back(study_json(*study, options, study->run(options)));
      write_study(folder, pages.back());
      done.emplace_back(study->name);
      mark();
    } else {
      pages.push_back(json::parse(read_whole(file)));
    }
    before += study->seconds;
    show(pages.back(), fresh);
  }
  if (list.size() > 1) write_whole(folder + "/README.md", index_of(pages));
  fs::remove(marker);
}

}  // namespace fairlight
