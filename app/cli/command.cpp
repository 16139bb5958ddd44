#include "app/cli/command.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>

namespace nacre::cli {

Option Option::required() const {
    option_->required();
    return *this;
}

Option Option::shows_default() const {
    option_->capture_default_str();
    return *this;
}

Option Option::needs(Option other) const {
    option_->needs(other.option_);
    return *this;
}

Option Option::excludes(Option other) const {
    option_->excludes(other.option_);
    return *this;
}

Option Option::within(double low, double high) const {
    option_->check(CLI::Validator(
        [=](std::string& text) {
            double value = 0;
            const bool within = CLI::detail::lexical_cast(text, value) && value >= low && value <= high;
            return within ? std::string() : fmt::format("{} is not a number from {} to {}", text, low, high);
        },
        fmt::format("FROM {} TO {}", low, high)));
    return *this;
}

Option Option::one_of(const std::vector<std::string>& names) const {
    option_->check(CLI::IsMember(names));
    return *this;
}

Option Option::check(const std::function<std::string(const std::string&)>& wrong) const {
    option_->check(wrong);
    return *this;
}

Option Option::pair(const std::string& shown) const {
    option_->delimiter(',')->expected(2)->type_name(shown);
    return *this;
}

void Option::demand() const {
    if (!given()) throw CLI::RequiredError(option_->get_name());
}

bool Option::given() const { return option_->count() > 0; }

template <class Value>
Option Command::option(const std::string& names, Value& value, const std::string& about) {
    return Option(app_.add_option(names, value, about));
}

template Option Command::option(const std::string&, std::string&, const std::string&);
template Option Command::option(const std::string&, int&, const std::string&);
template Option Command::option(const std::string&, float&, const std::string&);
template Option Command::option(const std::string&, double&, const std::string&);
template Option Command::option(const std::string&, std::vector<std::string>&, const std::string&);
template Option Command::option(const std::string&, std::vector<double>&, const std::string&);

Option Command::flag(const std::string& names, bool& value, const std::string& about) {
    return Option(app_.add_flag(names, value, about));
}

Option Command::option_read_by(const std::function<bool(const std::string&)>& read, const std::string& names,
                               const std::string& shown, const std::string& allowed,
                               const std::string& about) {
    const auto take = [=](const std::string& text) {
        if (!read(text)) throw CLI::ValidationError(names, allowed);
    };
    return Option(app_.add_option_function<std::string>(names, take, about)->type_name(shown));
}

void Command::footer(const std::string& text) { app_.footer(text); }

void Command::when_chosen(const std::function<void()>& action) { app_.callback(action); }

void throw_missing(const std::string& what) { throw CLI::RequiredError(what); }

void throw_wrong_usage(const std::string& why) { throw CLI::ValidationError(why); }

}  // namespace nacre::cli
