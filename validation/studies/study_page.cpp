#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include <fairlight/render/atomic_file.h>
#include <fairlight/stats/seed.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/studies/study_page.h>
#include <fairlight/version.h>

namespace fairlight {
namespace {

using nlohmann::json;

json cell_json(const Cell& cell) {
  if (const auto* word = std::get_if<std::string>(&cell)) return *word;
  if (const auto* number = std::get_if<double>(&cell)) return *number;
  const auto& [value, interval] = std::get<Measured>(cell);
  return {{"value", value}, {"interval", {interval.lo, interval.hi}}};
}

json table_json(const StudyTable& table) {
  json columns = json::array(), rows = json::array();
  for (const Column& column : table.columns) columns.push_back({{"name", column.name}, {"clock", column.of_clock}});
  for (const auto& row : table.rows) {
    rows.push_back(json::array());
    for (const Cell& cell : row) rows.back().push_back(cell_json(cell));
  }
  return {{"name", table.name}, {"caption", table.caption}, {"columns", columns}, {"rows", rows}};
}

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

// The mean number of processes that wanted to run in the last minute. Times measured at a load above
// the number of cores are those of a busy machine.
json load() {
  double last_minute = 0;
  return getloadavg(&last_minute, 1) == 1 ? json(last_minute) : json();
}

// Four digits; whole numbers and those from 1e4 to 1e9 without an exponent.
std::string number_text(const json& number) {
  if (number.is_null()) return "open";
  const auto x = number.get<double>();
  const bool whole = (x == std::round(x) && std::abs(x) < 1e9) || (std::abs(x) >= 1e4 && std::abs(x) < 1e9);
  return formatted(whole ? "%.0f" : "%.4g", x);
}

std::string cell_text(const json& cell) {
  if (cell.is_string()) return cell.get<std::string>();
  if (!cell.is_object()) return number_text(cell);
  const json& interval = cell.at("interval");
  return formatted("%s [%s, %s]", number_text(cell.at("value")).c_str(), number_text(interval[0]).c_str(),
                   number_text(interval[1]).c_str());
}

// The cells of a table as text, the heads first.
std::vector<std::vector<std::string>> texts(const json& table) {
  std::vector<std::vector<std::string>> all(1);
  for (const json& column : table.at("columns"))
    all[0].push_back(column.at("name").get<std::string>() + (column.at("clock").get<bool>() ? " *" : ""));
  for (const json& row : table.at("rows")) {
    all.emplace_back();
    for (const json& cell : row) all.back().push_back(cell_text(cell));
  }
  return all;
}

bool is_measured(const json& table, std::size_t column) {
  return std::ranges::any_of(table.at("rows"), [=](const json& row) { return row[column].is_object(); });
}

bool has_clock(const json& study) {
  for (const json& table : study.at("tables")) {
    for (const json& column : table.at("columns")) {
      if (column.at("clock").get<bool>()) return true;
    }
  }
  return false;
}

std::string csv_number(const json& number) { return number.is_null() ? "" : number.dump(); }

std::string csv_cell(const json& cell, bool measured) {
  if (cell.is_object()) {
    const json& interval = cell.at("interval");
    return csv_number(cell.at("value")) + "," + csv_number(interval[0]) + "," + csv_number(interval[1]);
  }
  const std::string text =
      cell.is_string() ? formatted("\"%s\"", cell.get<std::string>().c_str()) : csv_number(cell);
  return text + (measured ? ",," : "");
}

std::string markdown_table(const json& table) {
  std::string out = formatted("\n%s\n\n", table.at("caption").get<std::string>().c_str());
  bool head = true;
  for (const auto& row : texts(table)) {
    for (const std::string& text : row) out.append("| ").append(text).append(" ");
    out += "|\n";
    for (std::size_t i = 0; head && i < row.size(); ++i) out += i == 0 ? "|---" : "|--:";
    if (head) out += "|\n";
    head = false;
  }
  return out;
}

}  // namespace

json study_json(const Study& study, const StudyOptions& options, const StudyResult& result) {
  json tables = json::array(), pictures = json::array();
  for (const StudyTable& table : result.tables) tables.push_back(table_json(table));
  for (const auto& [file, caption] : result.pictures) pictures.push_back({{"file", file}, {"caption", caption}});
  // JSON has no infinity: written and read back, such a value is null.
  return json::parse(json{
      {"study", study.name},
      {"title", study.title},
      {"source", study.source},
      {"version", version},
      {"seed", seed_text(options.seed)},
      {"quick", options.quick},
      {"confidence", 0.95},
      {"processor", processor()},
      {"cores", hardware_threads()},
      {"load", load()},
      {"threads", options.threads},
      {"text", result.text},
      {"tables", tables},
      {"pictures",
       pictures}}.dump());
}

std::string table_csv(const json& table) {
  const json& columns = table.at("columns");
  std::string out;
  std::vector<bool> measured;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    measured.push_back(is_measured(table, i));
    const auto name = columns[i].at("name").get<std::string>();
    out += formatted(i == 0 ? "\"%s\"" : ",\"%s\"", name.c_str());
    if (measured[i]) out += formatted(",\"%s_lo\",\"%s_hi\"", name.c_str(), name.c_str());
  }
  out += "\n";
  for (const json& row : table.at("rows")) {
    for (std::size_t i = 0; i < row.size(); ++i)
      out.append(i == 0 ? "" : ",").append(csv_cell(row[i], measured[i]));
    out += "\n";
  }
  return out;
}

std::string study_markdown(const json& study) {
  const auto text = [&](const char* key) { return study.at(key).get<std::string>(); };
  std::string out = formatted("# %s\n\n%s\n", text("title").c_str(), text("text").c_str());
  for (const json& table : study.at("tables")) out += markdown_table(table);
  for (const json& picture : study.at("pictures")) {
    const auto caption = picture.at("caption").get<std::string>(), file = picture.at("file").get<std::string>();
    out += formatted("\n![%s](%s)\n\n%s\n", caption.c_str(), file.c_str(), caption.c_str());
  }
  const auto name = text("study");
  out += "\nBrackets are 95 % confidence intervals. ";
  if (has_clock(study))
    out += formatted("Columns with a * depend on the clock: CPU time of %s, %s cores, at a load of %s.\n",
                     text("processor").c_str(), study.at("cores").dump().c_str(),
                     number_text(study.at("load")).c_str());
  else
    out += "No value depends on the clock.\n";
  out += formatted("Source: %s. The numbers are also in `%s.json` and in CSV files.\n\n", text("source").c_str(),
                   name.c_str());
  return out + formatted("```\nfairlight study %s --seed %s%s --out DIR\n```\n", name.c_str(), text("seed").c_str(),
                         study.at("quick").get<bool>() ? " --quick" : "");
}

std::string study_text(const json& study) {
  std::string out = study.at("study").get<std::string>() + ": " + study.at("title").get<std::string>() + "\n";
  for (const json& table : study.at("tables")) {
    const auto rows = texts(table);
    std::vector<std::size_t> widths(rows[0].size());
    for (const auto& row : rows) {
      for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    }
    out += "\n";
    for (const auto& row : rows) {
      for (std::size_t i = 0; i < row.size(); ++i)
        out += formatted(i == 0 ? "%-*s" : "  %*s", static_cast<int>(widths[i]), row[i].c_str());
      out += "\n";
    }
  }
  return out;
}

void write_study(const std::string& folder, const json& study) {
  const std::string stem = folder + "/" + study.at("study").get<std::string>();
  for (const json& table : study.at("tables"))
    write_whole(stem + "-" + table.at("name").get<std::string>() + ".csv", table_csv(table));
  write_whole(stem + ".md", study_markdown(study));
  write_json(stem + ".json", study);
}

}  // namespace fairlight
