// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "desk/folder.hpp"

namespace berm::desk {

/// What a list says of a run with a summary: {title, date, answer: {name, value, unit}} as far as it has them. The answer is the key number of the kind of run.
Json digest_of(const Folder& folder, const std::filesystem::path& run);

/// Of all files in a folder, without following links.
std::uintmax_t bytes_in(const std::filesystem::path& folder);

/// notes.txt in the folder of a run: what its reader writes about it, "" where there is none. Throws Refusal of a link that leads out.
std::string notes_of(const Folder& folder, const std::filesystem::path& run);
/// Without a text there is none. Throws Refusal of one that is too long.
void write_notes(const Folder& folder, const std::filesystem::path& run, const std::string& text);

}  // namespace berm::desk
