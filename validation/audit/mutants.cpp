#include <algorithm>
#include <functional>
#include <random>
#include <regex>
#include <set>

#include <fairlight/stats/text.h>
#include <fairlight/validation/audit/mutants.h>

namespace fairlight {
namespace {

using Replacement = std::function<std::string(const std::string&)>;

struct Rule {
  std::string kind;
  std::regex pattern;       // the first group is replaced
  Replacement replacement;  // gives the new text
};

Replacement always(const std::string& text) {
  return [text](const std::string&) { return text; };
}

// Makes a number 2 % larger: "1" becomes "1.02". It has no suffix f, since a whole number with an f
// is not a literal.
std::string larger(const std::string& number) {
  const double value = std::stod(number);
  return formatted("%.6g", value == 0 ? 0.02 : 1.02 * value);
}

std::string escaped(const std::string& symbols) {
  std::string pattern;
  for (const char c : symbols) pattern += formatted("[%c]", c);
  return pattern;
}

std::vector<Rule> all_rules() {
  std::vector<Rule> rules;
  const auto swap = [&](const std::string& kind, const std::string& a, const std::string& b) {
    rules.push_back({kind, std::regex(formatted(" (%s) ", escaped(a).c_str())), always(b)});
    rules.push_back({kind, std::regex(formatted(" (%s) ", escaped(b).c_str())), always(a)});
  };
  const auto replace = [&](const std::string& kind, const char* pattern, const Replacement& replacement) {
    rules.push_back({kind, std::regex(pattern), replacement});
  };
  swap("operator", "+", "-");
  swap("operator", "*", "/");
  swap("operator", "+=", "-=");
  swap("operator", "*=", "/=");
  swap("order", "<", ">");
  swap("order", "<=", ">=");
  swap("logic", "&&", "||");
  replace("constant", R"(\b(?:Real|double|rounded<Real>)\((\d+(?:\.\d+)?)\))", larger);
  replace("constant", R"(\b(pi<Real>))", always("(Real(1.02) * pi<Real>)"));
  replace("cosine", R"(\.(z)\(\))", always("x"));
  replace("cosine", R"(\b(cos)\()", always("sin"));
  replace("cosine", R"(\b(sin)\()", always("cos"));
  replace("sign", R"((?:return |\(|= |, )(-)[\w(])", always(""));
  replace("extreme", R"(\b(min)\()", always("max"));
  replace("extreme", R"(\b(max)\()", always("min"));
  return rules;
}

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

void add_mutants(std::vector<Mutant>& mutants, const std::string& file, const Line& line) {
  static const std::vector<Rule> rules = all_rules();
  for (const Rule& rule : rules) {
    for (std::sregex_iterator match(line.code.begin(), line.code.end(), rule.pattern), end; match != end; ++match) {
      const auto place = static_cast<std::size_t>(match->position(1));
      const auto length = static_cast<std::size_t>(match->length(1));
      Mutant mutant{
          file, rule.kind, line.number, place + 1, line.begin + place, length, rule.replacement((*match)[1]),
          {},   {}};
      std::string after = line.text;
      after.replace(place, length, mutant.replacement);
      mutant.before = trimmed(line.text);
      mutant.after = trimmed(after);
      mutants.push_back(std::move(mutant));
    }
  }
}

}  // namespace

std::string Mutant::name() const {
  return formatted("%s:%d:%zu %s => %s", file.c_str(), line, column, before.c_str(), after.c_str());
}

std::vector<Mutant> mutants_of(const std::string& file, const std::string& text) {
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
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!checks[i]) add_mutants(mutants, file, lines[i]);
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
  chosen.resize(std::min(chosen.size(), n));
  return chosen;
}

}  // namespace fairlight
