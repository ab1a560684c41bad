#include <map>
#include <regex>
#include <sstream>

#include <support/house.h>
#include <support/temporary_folder.h>

namespace fairlight::testing {
namespace {

namespace fs = std::filesystem;

const std::map<std::string, int> chain{{"stats", 0}, {"estimators", 1}, {"render", 2}, {"validation", 3}};

std::vector<fs::path> sources(const fs::path& folder) {
  std::vector<fs::path> files;
  if (!fs::exists(folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const auto extension = entry.path().extension();
    if (extension == ".h" || extension == ".cpp") files.push_back(entry.path());
  }
  return files;
}

std::vector<std::string> lines_of(const fs::path& file) {
  std::istringstream text(read_file(file.string()));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

// A class at namespace level: its name, the comment above it and its body.
struct Component {
  std::string name, comment, body;
};

std::vector<Component> components(const fs::path& header) {
  static const std::regex declaration(R"(^(?:struct|class) (\w+)(?: final)? (?:: .*)?\{.*$)");
  std::vector<Component> found;
  std::string comment;
  bool inside = false;
  for (const std::string& line : lines_of(header)) {
    std::smatch match;
    if (inside) {
      found.back().body += line + "\n";
      inside = line != "};";
    } else if (line.starts_with("///")) {
      comment += line + "\n";
    } else if (std::regex_match(line, match, declaration)) {
      found.push_back({match[1], comment, ""});
      inside = line.find("};") == std::string::npos;
      comment.clear();
    } else if (!line.starts_with("template") &&
               !line.starts_with(" ")) {  // or its parameters, on a line of their own
      comment.clear();
    }
  }
  return found;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

bool is_component(const Component& c) {
  return has(c.body, " sample(") || has(c.body, " sum(") || has(c.body, " play(") || has(c.body, " estimate(") ||
         has(c.body, " next()") || has(c.body, " radiance(");
}

}  // namespace

std::vector<std::string> includes_up_the_chain(const fs::path& root) {
  static const std::regex include(R"(^\s*#\s*include\s*<fairlight/(\w+)/.*$)");
  static const std::regex quoted(R"(^\s*#\s*include\s*".*$)");
  std::vector<std::string> problems;
  for (const auto& [folder, rank] : chain) {
    for (const fs::path& file : sources(root / folder)) {
      for (const std::string& line : lines_of(file)) {
        std::smatch match;
        if (std::regex_match(line, quoted)) {
          problems.push_back(fs::relative(file, root).string() + " has a quoted include");
        }
        if (!std::regex_match(line, match, include)) continue;
        const auto target = chain.find(match[1]);
        if (target == chain.end() || target->second > rank) {
          problems.push_back(fs::relative(file, root).string() + " includes " + match[1].str() + ", up the chain");
        }
      }
    }
  }
  return problems;
}

std::vector<std::string> foreign_includes_in_stats(const fs::path& root) {
  static const std::regex include(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"].*$)");
  static const std::regex allowed(R"([a-z_0-9]+|Eigen/.*|boost/math/.*|fairlight/stats/.*)");
  static const std::regex frameworks(R"(gtest/gtest\.h|rapidcheck(/gtest)?\.h)");
  static const std::set<std::string> adapters{"googletest", "rapidcheck"};
  std::vector<std::string> problems;
  for (const fs::path& file : sources(root / "stats")) {
    if (file.extension() != ".h") continue;
    const bool adapts = adapters.contains(file.stem().string());
    for (const std::string& line : lines_of(file)) {
      std::smatch match;
      if (!std::regex_match(line, match, include) || std::regex_match(match[1].str(), allowed)) continue;
      if (adapts && std::regex_match(match[1].str(), frameworks)) continue;
      problems.push_back("stats/" + file.filename().string() + " includes " + match[1].str());
    }
  }
  return problems;
}

std::vector<std::string> components_without_papers(const fs::path& root, const std::set<std::string>& registered) {
  std::vector<std::string> problems;
  const std::string docs = read_file((root / "docs/estimators.md").string());
  std::vector<fs::path> files = sources(root / "estimators");
  for (const fs::path& file : sources(root / "render")) files.push_back(file);
  for (const fs::path& header : files) {
    if (header.extension() != ".h") continue;
    for (const Component& c : components(header)) {
      if (!is_component(c) || c.name.starts_with("Chosen")) continue;
      const auto missing = [&](const std::string& what) { problems.push_back(c.name + " has no " + what); };
      const bool has_density = has(c.body, " pdf(");
      for (const char* field : {"Formula", "Measure", "Domain", "Random", "Source"}) {
        const bool needed = has_density || std::string(field) == "Source";
        if (needed && !has(c.comment, std::string("/// ") + field + " ")) missing(std::string("field ") + field);
      }
      if (!registered.contains(c.name)) missing("row in the registry");
      if (!has(docs, "## " + c.name + "\n")) missing("section in docs/estimators.md");
      const std::string test =
          "tests/" + header.parent_path().filename().string() + "/" + header.stem().string() + "_test.cpp";
      if (!has(read_file((root / test).string()), c.name)) missing("test in " + test);
    }
  }
  return problems;
}

std::vector<std::string> missing_tests_of_bad_input(const fs::path& root) {
  static const std::regex definition(R"(^(?:TEST|TYPED_TEST|RC_GTEST_PROP)\((\w+), (\w+).*$)");
  static const std::regex mention(R"(`([A-Z]\w+\.[A-Z]\w+)`)");
  std::set<std::string> tests;
  for (const fs::path& file : sources(root / "tests")) {
    for (const std::string& line : lines_of(file)) {
      std::smatch match;
      if (std::regex_match(line, match, definition)) tests.insert(match[1].str() + "." + match[2].str());
    }
  }
  const std::string docs = read_file((root / "docs/estimators.md").string());
  const std::size_t start = docs.find("\n# Bad input\n");
  if (start == std::string::npos) return {"docs/estimators.md has no table of bad input"};
  const std::string table = docs.substr(start);
  std::vector<std::string> problems;
  for (std::sregex_iterator named(table.begin(), table.end(), mention), end; named != end; ++named) {
    if (!tests.contains((*named)[1])) problems.push_back("there is no test " + (*named)[1].str());
  }
  return problems;
}

}  // namespace fairlight::testing
