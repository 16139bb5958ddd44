// A small JSON file that the program keeps for itself, such as its settings.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "core/base/json_reader.h"

namespace nacre {

// Hands the object that the text is to `take`. What is wrong with it is a UserError of the file `name`, whose
// stem stands for the object in errors.
void read_object(const std::string& text, const std::string& name,
                 const std::function<void(ObjectReader&)>& take);

class PrivateJsonFile {
  public:
    // An empty path: there is nothing to read, and writing does nothing.
    explicit PrivateJsonFile(std::filesystem::path file = {}) : file_(std::move(file)) {}

    // Hands the file's text and name to `take`, which throws a UserError where it is wrong; nothing happens
    // where there is no file. A file that is refused is set aside under another name beside it before
    // anything is written in its place, and problem() says so.
    void read(const std::function<void(const std::string& text, const std::string& name)>& take);

    // Whole or not at all; its folder is made when it is not there. Does nothing while a refused file could
    // not be set aside.
    void write(const std::string& text);

    // What went wrong last, in one line; empty when nothing did.
    const std::string& problem() const { return problem_; }

  private:
    void set_aside(const std::string& why);

    std::filesystem::path file_;
    std::string problem_;
    bool untouchable_ = false;
};

// As JSON; what is not UTF-8 cannot stand there and is no value.
std::optional<std::string> json_path(const std::filesystem::path& path);

// A path that stands in JSON, or none where the text is empty. One that the system would read only the
// beginning of, up to a NUL, is a UserError.
std::filesystem::path read_path(const JsonValue& json);

}  // namespace nacre
