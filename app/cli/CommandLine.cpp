// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/CommandLine.h"

#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/Picture.h"
#include "cli/SupervisedChild.h"
#include "cli/commands/ConvertCommand.h"
#include "cli/commands/DevicesCommand.h"
#include "cli/commands/InspectCommand.h"
#include "cli/commands/MeasureCommand.h"
#include "cli/commands/RecordingCommand.h"
#include "cli/commands/SetCommand.h"
#include "text/EnglishPlurals.h"

#include <fcntl.h>
#include <unistd.h>
#include <QGuiApplication>
#include <algorithm>
#include <clocale>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <memory>
#include <new>
#include <stdexcept>
#include <system_error>

namespace handwheel {

namespace {

int runOnDevices(const Arguments& arguments, const Registered& registered) {
  return runDevices(arguments, registered.drivers());
}

int run(const Command& command, const Arguments& arguments, const Registered& registered) {
  if (const auto* onDocuments = std::get_if<Command::OnDocuments>(&command.run)) {
    return (*onDocuments)(arguments, registered.kinds);
  }
  return std::get<Command::OnAll>(command.run)(arguments, registered);
}

// Prepared in advance: it cannot be created when memory is exhausted.
std::string memorySentence;

// Ends the program if memory is exhausted in a thread of a library, or in a library that does not expect it. Nobody
// could catch the exception there.
[[noreturn]] void endForMemory() {
  try {
    if (std::current_exception()) throw;
    std::abort();
  } catch (const std::bad_alloc&) {
  } catch (const std::runtime_error& error) {
    if (!std::string_view(error.what()).starts_with("pthread_create")) std::abort();  // TBB reports it so
  } catch (...) {
    std::abort();
  }
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, memorySentence.data(), memorySentence.size());
  std::_Exit(kExitError);
}

// Runs the command and reports exhausted memory. The subject is the input of the command.
int runWithinMemory(const Command& command, const Arguments& arguments, const Registered& registered) {
  const std::string subject = arguments.operands.empty() ? std::string() : arguments.operands[0];
  memorySentence = "handwheel: " + fullSentenceFor({ErrorCode::OutOfMemory, {}, {}, subject}) + "\n";
  std::set_terminate(endForMemory);
  try {
    return run(command, arguments, registered);
  } catch (const std::bad_alloc&) {
    return failForMemory(subject);
  } catch (const std::length_error&) {
    return failForMemory(subject);
  } catch (const std::system_error& error) {
    // No further thread could be created.
    if (error.code() != std::errc::resource_unavailable_try_again) throw;
    return failForMemory(subject);
  }
}

bool plots(std::span<char* const> words) {
  return std::any_of(words.begin(), words.end(), [](std::string_view word) { return word.starts_with("--plot"); });
}

std::vector<Command> allCommands(const Registered& registered) {
  std::vector<Command> all{
      {inspectSpec(), runInspect},   {convertSpec(), runConvert, convertDetails},
      {pictureSpec(), runPicture},   {newSpec(), runNew, newDetails},
      {setSpec(), runSet},           {measureSpec(), runMeasure, nullptr, plots},
      {devicesSpec(), runOnDevices}, {recordingSpec(), runRecording},
  };
  all.insert(all.end(), registered.commands.begin(), registered.commands.end());
  return all;
}

const Command* find(const std::vector<Command>& all, std::string_view name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Command& c) { return c.spec.name == name; });
  return found == all.end() ? nullptr : &*found;
}

// A point within a word, as in ".stl", does not end the sentence.
std::string_view firstSentence(std::string_view text) {
  const std::size_t end = std::min(text.find(". "), text.find(".\n"));
  return end == std::string_view::npos ? text : text.substr(0, end + 1);
}

// Indents the lines after the first to the column.
std::string inColumn(std::string_view text, std::size_t column) {
  std::string lines(text);
  for (std::size_t at = lines.find('\n'); at != std::string::npos; at = lines.find('\n', at + 1))
    lines.insert(at + 1, column, ' ');
  return lines;
}

std::string overview(const Registered& registered) {
  std::string page =
      "Handwheel repairs scanned meshes, shapes and drills volumes, turns workpieces, plans robot cells, and sets and\n"
      "marks exercises.\n\n"
      "Usage: handwheel [--dark] [--screenshot PNG] [FILE...]   opens the window, or draws it and quits\n"
      "       handwheel COMMAND [...]                           works without it\n\n"
      "Commands:\n";
  const std::vector<Command> all = allCommands(registered);
  std::size_t width = 0;
  for (const Command& command : all) width = std::max(width, command.spec.name.size() + 2);
  for (const Command& command : all) {
    const std::string name(command.spec.name);
    page += "  " + name + std::string(width - name.size(), ' ') +
            inColumn(firstSentence(command.spec.summary), width + 2) + "\n";
  }
  return page +
         "\n"
         "'handwheel help COMMAND' gives details. --version shows the version.\n"
         "Exit codes: 0 done; 1 error; 2 incomplete, nothing changed, not reached or over budget (repair, edit, "
         "decimate,\n"
         "section, measure, feel, turn, train, mark, configuration, ik, plan, process, optimise-path, verify); 130\n"
         "interrupted.\n";
}

int helpOn(const Command& command, const Registered& registered) {
  return print(helpPage(command.spec, command.details ? command.details(registered.kinds) : std::string()));
}

int help(std::span<char* const> words, const Registered& registered) {
  if (words.empty()) return print(overview(registered));
  const std::vector<Command> all = allCommands(registered);
  const Command* command = find(all, words[0]);
  if (!command) return failUsage("There is no command " + std::string(words[0]) + ".", {});
  return helpOn(*command, registered);
}

bool isHelpWord(std::string_view word) {
  return word == "help" || word == "--help" || word == "-h";
}

// Qt's own options come with one dash or two and belong to the window.
bool isForWindow(std::string_view word) {
  static constexpr std::string_view kOptions[] = {"--screenshot", "--dark",    "--platform", "--style",
                                                  "--stylesheet", "--display", "--geometry"};
  return !word.starts_with("--") || word == "--" ||
         std::any_of(std::begin(kOptions), std::end(kOptions),
                     [&](std::string_view option) { return word.substr(0, word.find('=')) == option; });
}

// Returns true for a bare word that names no file either: a mistyped command rather than a file to open.
bool isMistypedCommand(std::string_view word) {
  std::error_code ignored;
  return !word.empty() && word.find_first_of("-./") == std::string_view::npos &&
         !std::filesystem::exists(word, ignored);
}

int dispatch(std::span<char* const> words, const Registered& registered) {
  const std::string_view first = words[0];
  const std::span<char* const> rest = words.subspan(1);
  if (isHelpWord(first)) return help(rest, registered);
  if (first == "--version") return print("Handwheel " HANDWHEEL_VERSION "\n");
  const std::vector<Command> all = allCommands(registered);
  const Command* command = find(all, first);
  if (!command)
    return failUsage(
        (first[0] == '-' ? "There is no option " : "There is no command or file ") + std::string(first) + ".", {});

  const Arguments arguments = parseArguments(command->spec, rest);
  if (!arguments.problem.empty()) return failUsage(arguments.problem, command->spec.name);
  if (arguments.has("help")) return helpOn(*command, registered);
  return runWithinMemory(*command, arguments, registered);
}

// Returns true if one of the words is the file name of a printed page. Documents are written to such files, too.
bool namesPage(std::span<char* const> words) {
  return std::any_of(words.begin(), words.end(),
                     [](std::string_view word) { return word.ends_with(".pdf") || word.ends_with(".PDF"); });
}

bool needsFonts(std::span<char* const> words, const Registered& registered) {
  const std::vector<Command> all = allCommands(registered);
  const Command* command = find(all, words[0]);
  return command && (namesPage(words.subspan(1)) || (command->needsFonts && command->needsFonts(words.subspan(1))));
}

// Creates a QGuiApplication for plots and printed pages, which need fonts; it needs no display.
std::unique_ptr<QCoreApplication> makeApplication(int& argc, char** argv, const Registered& registered) {
  if (!needsFonts(std::span<char* const>(argv, static_cast<std::size_t>(argc)).subspan(1), registered)) {
    return std::make_unique<QCoreApplication>(argc, argv);
  }
  qputenv("QT_QPA_PLATFORM", "offscreen");
  // The messages of Qt about the missing desktop are suppressed.
  const QtMessageHandler handler = qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});
  auto application = std::make_unique<QGuiApplication>(argc, argv);
  qInstallMessageHandler(handler);
  return application;
}

// Opens the standard streams that the shell has closed (2>&-). Otherwise a file could get the number of such a stream,
// and messages would go into it. Writing to such a stream still fails.
void occupyClosedStreams() {
  int descriptor = 0;
  while (descriptor >= 0 && descriptor <= STDERR_FILENO) descriptor = ::open("/dev/null", O_RDONLY);
  if (descriptor >= 0) ::close(descriptor);
}

}  // namespace

bool isCommand(int argc, char** argv, const Registered& registered) {
  if (argc < 2) return false;
  return isHelpWord(argv[1]) || find(allCommands(registered), argv[1]) || !isForWindow(argv[1]) ||
         isMistypedCommand(argv[1]);
}

int runCommand(int argc, char** argv, const Registered& registered) {
  occupyClosedStreams();
  watchSignals();
  endWithParent();
  try {
    const std::unique_ptr<QCoreApplication> application = makeApplication(argc, argv, registered);
    QCoreApplication::setOrganizationName(
        QStringLiteral("Handwheel"));  // these names locate the settings of the window
    QCoreApplication::setApplicationName(QStringLiteral("Handwheel"));
    EnglishPlurals plurals;
    QCoreApplication::installTranslator(&plurals);
    // QCoreApplication sets the user's locale. The command line uses English and the number format of C.
    std::setlocale(LC_ALL, "C");
    return dispatch(std::span<char* const>(argv, static_cast<std::size_t>(argc)).subspan(1), registered);
  } catch (const std::bad_alloc&) {
    return failForMemory({});
  }
}

}  // namespace handwheel
