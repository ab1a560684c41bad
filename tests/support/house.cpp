#include <algorithm>
#include <cctype>
#include <map>
#include <regex>
#include <sstream>

#include <support/house.h>
#include <support/non_components.h>
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

// A class or a function of a header that is for its users: its name, the comments above its
// declarations, and the class's body.
struct Declaration {
  std::string name, comment, body;
};

// What begins a line of a header, at its very left, and declares nothing that could be a component:
// a type by another name is one by its own.
bool declares_nothing(const std::string& line) {
  static const std::regex other(
      R"(^(?:template|requires|namespace|using|concept|enum|static_assert|extern|inline constexpr|constexpr|typedef)\b.*$)");
  static const std::regex function(R"(^(?:inline )?constexpr (?:[^={]*\(|.*= \[).*$)");
  static const std::regex operators(R"(^.*\boperator\b.*$)");
  static const std::regex guide(R"(^\w+\(.*\) -> .*$)");
  if (std::regex_match(line, function)) return std::regex_match(line, operators);
  return std::regex_match(line, other) || std::regex_match(line, operators) || std::regex_match(line, guide);
}

// Of a line that begins at the very left: the name that it declares; of one that is not understood
// all of it, lest something be missed.
std::string declared_by(const std::string& line) {
  static const std::regex type(R"(^(?:struct|class) (\w+).*$)");
  static const std::regex function(R"(^[\w:<>,&* ]+[ &*](\w+)\(.*$)");
  std::smatch match;
  return std::regex_match(line, match, type) || std::regex_match(line, match, function) ? match[1].str() : line;
}

// All but what is in namespaces called detail.
std::vector<Declaration> declarations(const fs::path& header) {
  static const std::regex opens_detail(R"(^namespace (?:\w+::)*detail \{.*$)");
  static const std::regex closes_detail(R"(^\}  // namespace (?:\w+::)*detail$)");
  std::vector<Declaration> found;
  std::map<std::string, std::size_t> places;
  std::string comment;
  Declaration* open = nullptr;  // the class that a line is in the body of
  bool hidden = false;
  for (const std::string& line : lines_of(header)) {
    const bool begins = !line.empty() && std::isalpha(static_cast<unsigned char>(line[0])) != 0;
    hidden = (hidden && !std::regex_match(line, closes_detail)) || std::regex_match(line, opens_detail);
    if (open != nullptr) {
      open->body += line + "\n";
      if (line == "};") open = nullptr;
    } else if (line.starts_with("///")) {
      comment += line + "\n";
    } else if (begins && !hidden && !declares_nothing(line)) {
      const auto [place, is_new] = places.try_emplace(declared_by(line), found.size());
      if (is_new) found.push_back({place->first, "", ""});
      Declaration& declaration = found[place->second];
      declaration.comment += comment;
      comment.clear();
      const bool is_class = line.starts_with("struct ") || line.starts_with("class ");
      if (is_class && !line.ends_with(";") && line.find("};") == std::string::npos) open = &declaration;
    } else if (!line.starts_with("template") &&
               !line.starts_with(" ")) {  // or its parameters, on a line of their own
      comment.clear();
    }
  }
  return found;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// Of render/, which composes: a class that is asked for numbers, or that the page has. One that
// looks up another while the program runs, Chosen..., is none.
bool is_composed(const Declaration& d, const std::set<std::string>& sections) {
  static const std::vector<std::string> methods{" sample(",   " sum(",   " play(",
                                                " estimate(", " next()", " radiance("};
  const auto has_method = [&](const std::string& method) { return has(d.body, method); };
  return sections.contains(d.name) || (!d.name.starts_with("Chosen") && std::ranges::any_of(methods, has_method));
}

// The names that headings of a page consist of, as in `## Name` or `## Name, Other`.
std::set<std::string> sections_of(const fs::path& page) {
  std::set<std::string> names;
  for (const std::string& line : lines_of(page)) {
    if (!line.starts_with("## ")) continue;
    std::istringstream heading(line.substr(3));
    for (std::string name; std::getline(heading >> std::ws, name, ',');) names.insert(name);
  }
  return names;
}

// All components under `root`, each with its header.
std::vector<std::pair<fs::path, Declaration>> components(const fs::path& root,
                                                         const std::set<std::string>& sections) {
  std::vector<std::pair<fs::path, Declaration>> found;
  const auto add = [&](const fs::path& folder, const auto& is_component) {
    for (const fs::path& header : sources(root / folder)) {
      if (header.extension() != ".h") continue;
      for (const Declaration& d : declarations(header)) {
        if (is_component(header.filename().string(), d)) found.emplace_back(header, d);
      }
    }
  };
  add("estimators", [](const std::string& header, const Declaration& d) {
    return !headers_without_components.contains(header) && !no_components.contains(d.name);
  });
  add("render", [&](const std::string&, const Declaration& d) { return is_composed(d, sections); });
  return found;
}

// What a component is to open with: all of it when it has a density.
std::vector<std::string> missing_fields(const Declaration& d) {
  std::vector<std::string> missing;
  for (const std::string field : {"Formula", "Measure", "Domain", "Random", "Source"}) {
    const bool needed = has(d.body, " pdf(") || field == "Source";
    const bool given = has(d.comment, "/// " + field + " ") || has(d.comment, field + ": ");
    if (needed && !given) missing.push_back(field);
  }
  return missing;
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

std::vector<std::string> unregistered_components(const fs::path& root, const std::set<std::string>& registered) {
  std::vector<std::string> problems;
  const std::set<std::string> sections = sections_of(root / "docs/estimators.md");
  for (const auto& component : components(root, sections)) {
    const fs::path& header = component.first;
    const Declaration& d = component.second;
    const auto missing = [&](const std::string& what) { problems.push_back(d.name + " has no " + what); };
    for (const std::string& field : missing_fields(d)) missing("field " + field);
    if (!registered.contains(d.name)) missing("row in the registry");
    if (!sections.contains(d.name)) missing("section in docs/estimators.md");
    const std::string test =
        "tests/" + header.parent_path().filename().string() + "/" + header.stem().string() + "_test.cpp";
    if (!has(read_file((root / test).string()), d.name)) missing("test in " + test);
  }
  return problems;
}

std::vector<std::string> sections_without_component(const fs::path& root) {
  std::set<std::string> sections = sections_of(root / "docs/estimators.md");
  for (const auto& [header, d] : components(root, sections)) sections.erase(d.name);
  return {sections.begin(), sections.end()};
}

std::vector<std::string> stale_non_components(const fs::path& root, const std::set<std::string>& registered) {
  std::vector<std::string> problems;
  std::set<std::string> declared;
  for (const fs::path& header : sources(root / "estimators")) {
    if (headers_without_components.contains(header.filename().string())) continue;
    for (const Declaration& d : declarations(header)) declared.insert(d.name);
  }
  for (const auto& [name, reason] : no_components) {
    if (!declared.contains(name)) problems.push_back(name + " is declared nowhere");
    if (registered.contains(name)) problems.push_back(name + " has a row in the registry");
  }
  for (const auto& [header, reason] : headers_without_components) {
    if (!fs::exists(root / "estimators" / header)) problems.push_back("there is no " + header);
    for (const Declaration& d : declarations(root / "estimators" / header)) {
      if (registered.contains(d.name)) problems.push_back(d.name + " of " + header + " has a row in the registry");
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
