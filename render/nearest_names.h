#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace fairlight {

/// The edits (insert, delete or replace a letter, swap two) that make a word the beginning of a name;
/// or, for one edit more, of a part of it after a '.', '-' or '_'. In the word '?' stands for any
/// letter and '*' for any number of them. Case and the dashes before an option do not count.
/// Source: Wagner and Fischer 1974; with swaps, the optimal string alignment distance.
std::size_t edits_to_beginning(const std::string& word, const std::string& name);

/// The names that a word may have been meant for, at most five, the nearest first: by the edits
/// above, then by those to the whole name, then in their order. None that takes two edits more than
/// the nearest, or edits of more than a third of the word's letters.
std::vector<std::string> nearest_names(const std::string& word, const std::vector<std::string>& names);

/// What to say after "there is no such name", in brackets: "(did you mean A or B? see `all`)",
/// where `all` is the command that lists all names; and only the latter when none is near.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& names, const std::string& all);

}  // namespace fairlight
