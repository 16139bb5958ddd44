// nacre-cli VERB ...
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/message.h"
#include "app/cli/output.h"
#include "app/cli/verbs.h"
#include "core/bake/bake.h"
#include "core/base/system/interrupt.h"
#include "core/base/system/standard_streams.h"

namespace {

using namespace nacre;

constexpr int done = 0, failed = 1, wrong_usage = 2;

int complain(std::string_view message, int exit_code) {
    cli::complain(message);
    return exit_code;
}

// Runs `work`, every failure one line on standard error.
template <class Work>
int guarded(const Work& work) {
    try {
        return work();
    } catch (const ReaderGone&) {
        return failed;
    } catch (const BakeCancelled&) {
        return complain("stopped", failed);
    } catch (const std::bad_alloc&) {
        return complain("there is not enough memory for this", failed);
    } catch (const std::exception& error) {
        return complain(error.what(), failed);
    }
}

int say(const std::string& text) {
    return guarded([&] {
        write_output(text);
        return done;
    });
}

void declare_all(CLI::App& app, cli::Action& action) {
    app.set_version_flag("--version", "nacre-cli " NACRE_VERSION);
    app.require_subcommand(1);
    app.footer(
        "nacre-cli VERB --help tells a verb's own options. Exit codes: 0 done, 1 it could not be done or a\n"
        "check failed, 2 wrong usage. Angles in degrees, theta from the normal, phi from the tangent.");
    for (const cli::Verb* verb : cli::verbs()) {
        cli::Command command(*app.add_subcommand(verb->name, verb->about));
        verb->declare(command, action);
    }
}

// CLI11 takes -o=FILE for the option -o with the value "=FILE"; of a long option it takes it as meant.
std::string long_form(const CLI::App& verb, const std::string& word) {
    if (word.size() < 3 || word[0] != '-' || word[1] == '-' || word[2] != '=') return word;
    const CLI::Option* option = verb.get_option_no_throw(word.substr(0, 2));
    if (option == nullptr || option->get_lnames().empty() || option->get_expected_min() == 0) return word;
    if (word.size() == 3) throw CLI::ArgumentMismatch(word + " has no value");
    return "--" + option->get_lnames().front() + word.substr(2);
}

// Last word first, as CLI11 takes them.
std::vector<std::string> words_of(const CLI::App& app, int argc, const char* const* argv) {
    std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
    const auto named = [&](const CLI::App* verb) { return !words.empty() && verb->get_name() == words[0]; };
    for (const CLI::App* verb : app.get_subcommands(named))
        for (auto word = words.begin(); word != words.end() && *word != "--"; ++word)
            *word = long_form(*verb, *word);
    std::reverse(words.begin(), words.end());
    return words;
}

bool is_verb(std::string_view name) {
    const auto& verbs = cli::verbs();
    return std::any_of(verbs.begin(), verbs.end(), [&](const cli::Verb* verb) { return verb->name == name; });
}

}  // namespace

int main(int argc, char** argv) {
    prepare_streams();
    CLI::App app("Nacre without a window: microfacet BRDFs designed by their normal distribution",
                 "nacre-cli");
    cli::Action action;
    try {
        declare_all(app, action);
        if (argc > 1 && argv[1][0] != '-' && !is_verb(argv[1]))
            return complain(fmt::format("there is no verb {}; see nacre-cli --help", argv[1]), wrong_usage);
        app.parse(words_of(app, argc, argv));
    } catch (const CLI::CallForHelp&) {
        return say(app.help());
    } catch (const CLI::CallForAllHelp&) {
        return say(app.help("", CLI::AppFormatMode::All));
    } catch (const CLI::CallForVersion& version) {
        return say(std::string(version.what()) + "\n");
    } catch (const CLI::ParseError& error) {
        return complain(std::string(error.what()) + "; see nacre-cli --help", wrong_usage);
    } catch (const std::exception& error) {
        return complain(error.what(), failed);
    }
    return guarded([&] {
        Interrupt interrupt("nacre-cli: stopped\n");
        return action(interrupt);
    });
}
