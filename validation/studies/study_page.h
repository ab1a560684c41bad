#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include <fairlight/validation/studies/study.h>

namespace fairlight {

/// The whole result of a study as JSON; text, CSV and Markdown are made from it alone, so that they
/// cannot differ. {study, title, source, version, seed, quick, confidence, processor, cores, load, threads, text,
/// tables: [{name, caption, columns: [{name, clock}], rows: [[cell, ...], ...]}], pictures: [{file,
/// caption}]}. A measured cell is {value, interval: [lo, hi]}; an end or a value that is not finite
/// is null. The values of a column with `clock` depend on the time that something took; all others
/// are the same for the same seed.
nlohmann::json study_json(const Study& study, const StudyOptions& options, const StudyResult& result);

/// The table as CSV: a measured column NAME becomes NAME, NAME_lo and NAME_hi.
std::string table_csv(const nlohmann::json& table);

/// The page of the study.
std::string study_markdown(const nlohmann::json& study);

/// The tables, for a terminal.
std::string study_text(const nlohmann::json& study);

/// Writes NAME-TABLE.csv, NAME.md and then NAME.json: a study with a JSON file is complete. Throws
/// std::runtime_error.
void write_study(const std::string& folder, const nlohmann::json& study);

}  // namespace fairlight
