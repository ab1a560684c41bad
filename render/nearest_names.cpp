#include <algorithm>
#include <cctype>
#include <tuple>

#include <fairlight/render/nearest_names.h>

namespace fairlight {
namespace {

constexpr std::size_t most_names = 5;

// The text in lower case, without the dashes before an option.
std::string bare(std::string text) {
  text.erase(0, std::min(text.find_first_not_of('-'), text.size()));
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool ends_part(char c) { return c == '.' || c == '-' || c == '_'; }

// Row i of the table: element j is the number of edits that turn the first i letters of the word
// into the first j letters of the name.
using Row = std::vector<std::size_t>;

// Row 0. The start of a name costs one edit per letter; with may_lose_parts, whole first parts cost
// one edit.
Row first_row(const std::string& name, bool may_lose_parts) {
  Row row(name.size() + 1);
  for (std::size_t j = 1; j < row.size(); ++j)
    row[j] = may_lose_parts && ends_part(name[j - 1]) ? 1 : row[j - 1] + 1;
  return row;
}

Row next_row(const std::string& word, const std::string& name, std::size_t i, const Row& above,
             const Row& two_above) {
  const char letter = word[i - 1];
  const bool any_number = letter == '*';
  Row row(above.size());
  row[0] = above[0] + (any_number ? 0 : 1);
  for (std::size_t j = 1; j < row.size(); ++j) {
    if (any_number) {
      row[j] = std::min(above[j], row[j - 1]);
      continue;
    }
    const bool same = letter == name[j - 1] || letter == '?';
    row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (same ? 0 : 1)});
    if (i > 1 && j > 1 && letter == name[j - 2] && word[i - 2] == name[j - 1])
      row[j] = std::min(row[j], two_above[j - 2] + 1);
  }
  return row;
}

// The last row: element j is the number of edits that turn the whole word into the first j letters
// of the name.
Row edits(const std::string& word, const std::string& name, bool may_lose_parts) {
  Row two_above, above, row = first_row(name, may_lose_parts);
  for (std::size_t i = 1; i <= word.size(); ++i) {
    two_above = std::move(above);
    above = std::move(row);
    row = next_row(word, name, i, above, two_above);
  }
  return row;
}

}  // namespace

std::size_t edits_to_beginning(const std::string& word, const std::string& name) {
  return std::ranges::min(edits(bare(word), bare(name), true));
}

std::vector<std::string> nearest_names(const std::string& word, const std::vector<std::string>& names) {
  // The edits, the edits to the whole name, and the index.
  using Candidate = std::tuple<std::size_t, std::size_t, std::size_t>;
  std::vector<Candidate> near;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::size_t to_beginning = edits_to_beginning(word, names[i]);
    if (3 * to_beginning <= bare(word).size())
      near.emplace_back(to_beginning, edits(bare(word), bare(names[i]), false).back(), i);
  }
  std::ranges::sort(near);
  std::vector<std::string> nearest;
  for (const auto& [to_beginning, to_all, i] : near) {
    if (nearest.size() == most_names || to_beginning > std::get<0>(near.front()) + 1) break;
    if (std::ranges::find(nearest, names[i]) == nearest.end()) nearest.push_back(names[i]);
  }
  return nearest;
}

std::string alternatives(const std::vector<std::string>& names) {
  std::string list = names.front();
  for (std::size_t i = 1; i < names.size(); ++i) list += (i + 1 < names.size() ? ", " : " or ") + names[i];
  return list;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& names, const std::string& all) {
  const std::vector<std::string> nearest = nearest_names(word, names);
  if (nearest.empty()) return "(see " + all + ")";
  return "(did you mean " + alternatives(nearest) + "? see " + all + ")";
}

}  // namespace fairlight
