// A verb's options. CLI11 stays in command.cpp and main.cpp: its headers take several times longer to compile
// than a verb.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace nacre::cli {

// One option of a command, to be copied freely; it lives as long as the command line.
class Option {
  public:
    explicit Option(CLI::Option* option) : option_(option) {}

    Option required() const;
    Option shows_default() const;
    Option needs(Option other) const;
    Option excludes(Option other) const;

    // What values are allowed. `wrong` returns what is wrong with a text, or nothing.
    Option within(double low, double high) const;  // "nan" is in no range
    Option one_of(const std::vector<std::string>& names) const;
    Option check(const std::function<std::string(const std::string&)>& wrong) const;

    // The value is two values, a comma between them; --help shows `shown`.
    Option pair(const std::string& shown) const;

    // Wrong usage where the option was not given: for one that is required only sometimes.
    void demand() const;
    bool given() const;

  private:
    CLI::Option* option_;
};

class Command {
  public:
    explicit Command(CLI::App& app) : app_(app) {}

    // `names` as CLI11 has them: "-o,--output", or "DESIGN" for a place on the line. Value is a std::string,
    // an int, float or double, or a vector of strings or doubles; it must live until the line has been read.
    template <class Value>
    Option option(const std::string& names, Value& value, const std::string& about);

    Option flag(const std::string& names, bool& value, const std::string& about);

    // An option whose text `read` takes; where it returns false the usage is wrong, and `allowed` says why.
    Option option_read_by(const std::function<bool(const std::string&)>& read, const std::string& names,
                          const std::string& shown, const std::string& allowed, const std::string& about);

    void footer(const std::string& text);
    void when_chosen(const std::function<void()>& action);

  private:
    CLI::App& app_;
};

// Wrong usage: the command line lacks `what`.
[[noreturn]] void throw_missing(const std::string& what);

// Wrong usage for another reason.
[[noreturn]] void throw_wrong_usage(const std::string& why);

}  // namespace nacre::cli
