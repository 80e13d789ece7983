// The command line of a serial program, with errors that say what was meant.
#pragma once

namespace CLI {
class App;
}

namespace ritz::tools {

/// Parses. Throws InputError of one line, which names the nearest option for an unknown one; CLI::CallForHelp
/// and CLI::CallForVersion pass.
void parse(CLI::App& app, int argc, const char* const* argv);

}  // namespace ritz::tools
