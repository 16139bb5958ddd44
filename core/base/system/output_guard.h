// No output is one of the inputs, and no two outputs are one file.
#pragma once

#include <filesystem>
#include <vector>

namespace nacre {

// Call this before anything is written. Files are compared by identity and not by name: links
// of both kinds, `..` and, where a folder ignores it, the case of letters lead to the same file. A UserError
// about the output that also names what it would overwrite. An input that is no file is none:
// not there, a name of something built in, a pipe.
void check_outputs(const std::vector<std::filesystem::path>& outputs,
                   const std::vector<std::filesystem::path>& inputs);

// Whether the folder takes "A" and "a" for one name; of one that is not there, the folder it would lie in.
bool ignores_case(const std::filesystem::path& folder);

// The name as such a folder compares it, with case folded.
std::string without_case(const std::string& utf8);

}  // namespace nacre
