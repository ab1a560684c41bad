#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace fairlight {

/// The number of edits (insert, delete or replace a letter, swap two) that turn a word into the
/// beginning of a name, or, for one edit more, of a part of the name after a '.', '-' or '_'. In
/// the word '?' matches any letter and '*' any number of letters. Ignores case and the dashes
/// before an option.
/// Source   Wagner and Fischer 1974; with swaps, the optimal string alignment distance
std::size_t edits_to_beginning(const std::string& word, const std::string& name);

/// At most five names that a word may stand for, the nearest first: by the edits above, then by the
/// edits to the whole name, then in the given order. Leaves out names that take two edits more than
/// the nearest, or more edits than a third of the word's letters.
std::vector<std::string> nearest_names(const std::string& word, const std::vector<std::string>& names);

/// "A", "A or B", "A, B or C".
std::string alternatives(const std::vector<std::string>& names);

/// A hint for an unknown name: "(did you mean A or B? see `all`)", where `all` is the command that
/// lists all names. When no name is near, only the part on `all`.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& names, const std::string& all);

}  // namespace fairlight
