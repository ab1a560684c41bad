#include <array>
#include <stdexcept>

#include <fairlight/stats/text.h>
#include <fairlight/validation/audit/mutation_rules.h>

namespace fairlight {
namespace {

// Stands for "2 % larger, or 0.02 for 0" in place of a format.
constexpr const char* larger = "larger";

struct Row {
  const char* kind;
  const char* needs;
  const char* pattern;  // @ is an operand, # a pair of parentheses with what is inside
  const char* format;
  const char* signature = "";
};

constexpr std::array slips{
    Row{"operator", " + ", R"( (\+) )", "-"},
    Row{"operator", " - ", R"( (-) )", "+"},
    Row{"operator", " * ", R"( (\*) )", "/"},
    Row{"operator", " / ", R"( (/) )", "*"},
    Row{"operator", " += ", R"( (\+=) )", "-="},
    Row{"operator", " -= ", R"( (-=) )", "+="},
    Row{"operator", " *= ", R"( (\*=) )", "/="},
    Row{"operator", " /= ", R"( (/=) )", "*="},
    Row{"order", " < ", " (<) ", ">"},
    Row{"order", " > ", " (>) ", "<"},
    Row{"order", " <= ", " (<=) ", ">="},
    Row{"order", " >= ", " (>=) ", "<="},
    Row{"logic", " && ", " (&&) ", "||"},
    Row{"logic", " || ", R"( (\|\|) )", "&&"},
    Row{"constant", "(", R"(\b(?:Real|double|rounded<Real>)\((\d+(?:\.\d+)?)\))", larger},
    Row{"constant", "pi<Real>", R"(\b(pi<Real>))", "(Real(1.02) * pi<Real>)"},
    Row{"cosine", ".z()", R"(\.(z)\(\))", "x"},
    Row{"cosine", "cos(", R"(\b(cos)\()", "sin"},
    Row{"cosine", "sin(", R"(\b(sin)\()", "cos"},
    Row{"sign", "-", R"((?:return |\(|= |, )(-)[\w(])", ""},
    Row{"extreme", "min(", R"(\b(min)\()", "max"},
    Row{"extreme", "max(", R"(\b(max)\()", "min"},
};

// Functions by their first line.
constexpr const char* of_numbers =
    R"(^\s*(?:static |constexpr |inline |friend )*(?:Real|double|float|Number|Scalar|Value|auto|Rgb<|Vec[23]<|Density<))";
constexpr const char* that_sample = R"(\b(?:sample\w*|at|draw\w*|pixel_ray|ray\w*)\()";
constexpr const char* of_densities = R"(\b\w*(?:pdf|density|probability)\w*\()";

constexpr std::array meaning{
    Row{"clamp", "return ", R"(\breturn (?![{*]|true|false|\d)([^;{}]*[\w\])>]);)", "mutation::at_most($1, 0.9)",
        of_numbers},
    Row{"clamp", " += ", R"( \+= (?!\d)([^;{}]+);)", "mutation::at_most($1, 3)"},
    Row{"floor", " / ", R"( / (?!Real\(\d|rounded<Real>\(\d|\d|pi<)(@))", "mutation::at_least($1, 0.1)"},
    Row{"bound", "for (", R"(\bfor \([^;]*; \w+ <=? ([^;&]+?)(?= && |;))", "$1 - 1"},
    Row{"bound", "for (", R"(\bfor \([^;]* = (0)[;,])", "1"},
    Row{"bound", " + 1", R"(( \+ 1)(?![\w.]))", ""},
    Row{"bound", " - 1", R"(( - 1)(?![\w.]))", ""},
    Row{"term", " + ", R"(( \+ @(?: [*/] @)*))", ""},
    Row{"term", " - ", R"(( - @(?: [*/] @)*))", ""},
    Row{"term", " + ", R"((@(?: [*/] @)* \+ ))", ""},
    Row{"factor", " * ", R"(( \* @))", ""},
    Row{"factor", " * ", R"((@ \* ))", ""},
    Row{"factor", " / ", R"(( / @))", ""},
    Row{"swap", ", ", R"(\b(?!min\b|max\b|dot\b|select\b)\w+(?:<[\w, ]*>)?[({]((@), (@))(?=[,)}]))", "$3, $2"},
    Row{"swap", ", ", R"(, ((@), (@))(?=[)}]))", "$3, $2"},
    Row{"swap", "[0]", R"(\[(0)\])", "1"},
    Row{"swap", "[1]", R"(\[(1)\])", "0"},
    Row{"swap", "[2]", R"(\[(2)\])", "1"},
    Row{"swap", ".x()", R"(\b(?!u\.)\w+\.(x)\(\))", "y"},
    Row{"swap", ".y()", R"(\b(?!u\.)\w+\.(y)\(\))", "x"},
    Row{"reuse", "u", R"(\bu\w*\.(y)\(\))", "x"},
    Row{"reuse", "u", R"(\bu\w*\.(x)\(\))", "y"},
    Row{"reuse", ".next()", R"((\{(\w+), \w+\.next\(\)\}))", "{$2, $2}"},
    Row{"branch", "if (", R"(\bif (?!\(.*\b(?:any|all)\()(#))", "(false)"},
    Row{"branch", " > ", R"((?:\bif \(|\bselect\(|Mask<|\?).* >=? (@)(?=[ ),;]|$))", "mutation::raised($1)"},
    Row{"branch", " < ", R"((?:\bif \(|\bselect\(|Mask<|\?).* <=? (@)(?=[ ),;]|$))", "mutation::lowered($1)"},
    Row{"branch", "select(", R"((?:^|[^.\w])(select)\()", "mutation::always"},
    Row{"branch", "select(", R"((?:^|[^.\w])(select)\()", "mutation::never"},
    Row{"branch", "select(", R"((?:^|[^.\w])(select)(?=\((?:#|[^,()])*, (?!(?:Real|rounded<Real>)\(-?\d|zero<)))",
        "mutation::partly"},
    Row{"sample", "u.", R"(\b(u\.[xy]\(\)))", "mutation::scaled($1, 0.9)", that_sample},
    Row{"sample", ".next()", R"((\b\w+\.next\(\)))", "mutation::scaled($1, 0.9)", that_sample},
    Row{"pdf", "return ", R"(\breturn (?![{*]|true|false)([^;{}]*[\w\])>]);)", "mutation::scaled($1, 1.1)",
        of_densities},
    Row{"pdf", "Density<", R"(\bDensity<[\w, ]+>(#))", "(mutation::scaled($1, 1.1))", of_densities},
    Row{"probability", " < ", R"((?:\bu|\bu\.[xy]\(\)|\.next\(\)|\bchoice) <=? (@))", "mutation::scaled($1, 0.9)"},
    Row{"probability", "Density<Discrete", R"(\bDensity<Discrete, \w+>(#))", "(mutation::scaled($1, 0.9))"},
    Row{"probability", "probabilit", R"( [*/] (\w*(?:\.\w+)*\.?\w*probabilit\w*#?))", "mutation::scaled($1, 0.9)"},
    Row{"float", "double ", R"(^\s+(double) \w+ = )", "float", "."},
    Row{"float", "array<double", R"(^\s+std::array<(double), )", "float", "."},
    Row{"state", " = ",
        R"(^\s+(?!return|const |auto )([\w.>\[\]-]+ = (?:0|Real\(-?\d+\)|false|true|\{\}|zero<[^;]*|select\(\w+, [^;]*);))",
        ";", "."},
    Row{"state", "(", R"(^\s+([\w.>\[\]-]+(?:\.|->)(?:clear|reset|fill|setZero)\([^;]*\);))", ";", "."},
};

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

std::regex pattern_of(const Row& row) {
  const std::string parentheses = R"((?:\((?:[^()]|\((?:[^()]|\([^()]*\))*\))*\)))";
  const std::string operand = R"((?:[A-Za-z_][\w:]*(?:<[\w, ]+>)?(?:#|\.\w+|->\w+|\[[^\]]*\])*|#|\d[\w.]*))";
  return std::regex(replaced(replaced(row.pattern, "@", operand), "#", parentheses));
}

MutationRule rule_of(const Row& row, Operators of) {
  const std::string signature = row.signature;
  return {row.kind, of, row.needs, pattern_of(row), row.format, std::regex(signature), signature.empty()};
}

}  // namespace

Operators operators_named(const std::string& name) {
  if (name == "slips") return Operators::slips;
  if (name == "meaning") return Operators::meaning;
  if (name == "all") return Operators::all;
  throw std::invalid_argument("there are no operators \"" + name + "\" (choose slips, meaning or all)");
}

// A larger number has no suffix f, since a whole number with an f is not a literal.
std::string MutationRule::replacement(const std::smatch& match) const {
  if (format != larger) return match.format(format);
  const double value = std::stod(match[1]);
  return formatted("%.6g", value == 0 ? 0.02 : 1.02 * value);
}

const std::vector<MutationRule>& mutation_rules() {
  static const std::vector<MutationRule> rules = [] {
    std::vector<MutationRule> all;
    for (const Row& row : slips) all.push_back(rule_of(row, Operators::slips));
    for (const Row& row : meaning) all.push_back(rule_of(row, Operators::meaning));
    return all;
  }();
  return rules;
}

}  // namespace fairlight
