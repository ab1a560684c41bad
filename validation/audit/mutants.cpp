#include <algorithm>
#include <map>
#include <optional>
#include <random>
#include <regex>
#include <set>

#include <fairlight/stats/text.h>
#include <fairlight/validation/audit/mutants.h>

namespace fairlight {
namespace {

bool is_check(const std::string& line) {
  static const std::regex check(
      R"(^\s*(#|template|using|static_assert|friend|namespace)|\bthrow\b|\brequires?\w*\b|operator)");
  return std::regex_search(line, check);
}

// The text with blanks in place of comments, strings and characters. The length stays the same.
std::string code_of(const std::string& text) {
  static const std::regex no_code(R"(//[^\n]*|/\*[^*]*\*/|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])')");
  std::string code = text;
  for (std::sregex_iterator match(text.begin(), text.end(), no_code), end; match != end; ++match) {
    std::fill_n(code.begin() + match->position(), match->length(), ' ');
  }
  return code;
}

std::string trimmed(const std::string& line) {
  const std::size_t first = line.find_first_not_of(' ');
  return first == std::string::npos ? "" : line.substr(first);
}

struct Line {
  std::size_t begin;
  int number;
  std::string code, text;
};

bool throws(const Line& line) { return line.code.find("throw ") != std::string::npos; }

// The masks that checks test: those in a condition on the line of a throw or on the line above.
std::set<std::string> masks_of_checks(const std::vector<Line>& lines) {
  static const std::regex mask(R"(\b(?:all|any)\((\w+)\b)");
  std::set<std::string> names;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!throws(lines[i]) && !(i + 1 < lines.size() && throws(lines[i + 1]))) continue;
    for (std::sregex_iterator match(lines[i].code.begin(), lines[i].code.end(), mask), end; match != end; ++match)
      names.insert((*match)[1]);
  }
  return names;
}

// Whether each line belongs to a check. It does if it throws, if the next line throws, or if it
// adds to a mask that a check tests, as `inside = inside && ...` does, up to the end of that
// statement.
std::vector<bool> lines_of_checks(const std::vector<Line>& lines) {
  static const std::regex addition(R"(\b(\w+) = \1 && )");
  const std::set<std::string> masks = masks_of_checks(lines);
  std::vector<bool> checks;
  bool goes_on = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& code = lines[i].code;
    std::smatch match;
    const bool adds = goes_on || (std::regex_search(code, match, addition) && masks.contains(match[1]));
    goes_on = adds && !code.ends_with(';');
    checks.push_back(adds || is_check(code) || (i + 1 < lines.size() && throws(lines[i + 1])));
  }
  return checks;
}

// Whether each line is compiled only for instruction sets beyond the baseline, for which mutants are
// compiled. Of nested conditions, any counts.
std::vector<bool> lines_of_wide_sets(const std::vector<Line>& lines) {
  static const std::regex opening(R"(^#\s*if)"), other(R"(^#\s*el)"), closing(R"(^#\s*endif)");
  static const std::regex wide(R"((?:^|[^!])defined\(__AVX)");
  std::vector<bool> inside, of_wide_sets;
  for (const Line& line : lines) {
    if (std::regex_search(line.code, closing) && !inside.empty()) inside.pop_back();
    if (std::regex_search(line.code, opening)) inside.push_back(false);
    if (!inside.empty() && (std::regex_search(line.code, opening) || std::regex_search(line.code, other)))
      inside.back() = std::regex_search(line.code, wide);
    of_wide_sets.push_back(std::ranges::find(inside, true) != inside.end());
  }
  return of_wide_sets;
}

// A function of a source, from its first line to its last.
struct Function {
  std::string signature;  // its first line
  int first, last;
};

// The functions around each line, of code that clang-format has laid out: a function begins with a
// line that has a name and a parenthesis, and ends with the brace in the column where it began.
std::vector<std::optional<Function>> functions_of(const std::vector<Line>& lines) {
  static const std::regex head(
      R"(^( {0,4})(?!return |if |for |while |switch |else|using |#|\}|:|namespace)[^;=]*?\b[~\w]+\([^;]*$)");
  static const std::regex whole(R"(^ {0,4}\S[^=]*?\b\w+\(.*\{ .* \}$)");
  std::vector<std::optional<Function>> functions(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::smatch match;
    if (std::regex_search(lines[i].code, whole)) {
      functions[i] = Function{lines[i].code, lines[i].number, lines[i].number};
      continue;
    }
    if (!std::regex_search(lines[i].code, match, head)) continue;
    const std::string end = match[1].str() + "}";
    std::size_t last = i + 1;
    while (last < lines.size() && lines[last].code.find_first_not_of(' ') >= end.size() && lines[last].code != end)
      ++last;
    if (last == lines.size() || !lines[last].code.starts_with(end)) continue;
    for (std::size_t k = i; k <= last; ++k)
      functions[k] = Function{lines[i].code, lines[i].number, lines[last].number};
    i = last;
  }
  return functions;
}

bool applies(const MutationRule& rule, Operators operators, const Line& line,
             const std::optional<Function>& function) {
  if (operators != Operators::all && rule.of != operators) return false;
  if (line.code.find(rule.needs) == std::string::npos) return false;
  // Errors of meaning are about numbers: a line with a text makes a message.
  if (rule.of == Operators::meaning && line.text.find('"') != std::string::npos) return false;
  return rule.any_function || (function && std::regex_search(function->signature, rule.signature));
}

void add_mutants(std::vector<Mutant>& mutants, const std::string& file, Operators operators, const Line& line,
                 const std::optional<Function>& function) {
  std::set<std::string> texts{line.text};
  for (const MutationRule& rule : mutation_rules()) {
    if (!applies(rule, operators, line, function)) continue;
    for (std::sregex_iterator match(line.code.begin(), line.code.end(), rule.pattern), end; match != end; ++match) {
      const auto place = static_cast<std::size_t>(match->position(1));
      const auto length = static_cast<std::size_t>(match->length(1));
      std::string after = line.text;
      const std::string replacement = rule.replacement(*match);
      after.replace(place, length, replacement);
      if (!texts.insert(after).second) continue;
      mutants.push_back({file, rule.kind, line.number, place + 1, line.begin + place, length, replacement,
                         trimmed(line.text), trimmed(after), function ? function->first : line.number,
                         function ? function->last : line.number});
    }
  }
}

}  // namespace

std::string Mutant::name() const {
  return formatted("%s:%d:%zu %s => %s", file.c_str(), line, column, before.c_str(), after.c_str());
}

std::vector<Mutant> mutants_of(const std::string& file, const std::string& text, Operators operators) {
  const std::string code = code_of(text);
  std::vector<Line> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back({begin, static_cast<int>(lines.size()) + 1, code.substr(begin, end - begin),
                     text.substr(begin, end - begin)});
    begin = end + 1;
  }
  std::vector<Mutant> mutants;
  const std::vector<bool> checks = lines_of_checks(lines);
  const std::vector<bool> wide = lines_of_wide_sets(lines);
  const std::vector<std::optional<Function>> functions = functions_of(lines);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!checks[i] && !wide[i]) add_mutants(mutants, file, operators, lines[i], functions[i]);
  }
  std::ranges::stable_sort(mutants, {}, &Mutant::begin);
  return mutants;
}

std::string mutated(const std::string& text, const Mutant& mutant) {
  std::string changed = text;
  return changed.replace(mutant.begin, mutant.length, mutant.replacement);
}

std::vector<Mutant> sample_of(const std::vector<Mutant>& all, std::size_t n, std::uint64_t seed) {
  std::vector<Mutant> chosen = all;
  std::ranges::shuffle(chosen, std::mt19937_64(seed));
  std::map<std::string, std::size_t> drawn;
  std::vector<std::pair<std::size_t, Mutant>> turns;
  for (Mutant& mutant : chosen) turns.emplace_back(drawn[mutant.kind]++, std::move(mutant));
  std::ranges::stable_sort(turns, {}, &std::pair<std::size_t, Mutant>::first);
  turns.resize(std::min(turns.size(), n));
  chosen.clear();
  for (auto& [turn, mutant] : turns) chosen.push_back(std::move(mutant));
  return chosen;
}

}  // namespace fairlight
