// The commands: what each is called, its key, what it does.
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "graph/controls.h"
#include "text/diagnostics.h"
#include "view/commands.h"
#include "view/viewer.h"

namespace nephrite::view {
namespace {

using Words = std::vector<std::string>;

constexpr std::string_view blanks = " \t";
constexpr double greatestExposure = 1e30;  ///< as the pass `display` has it

[[noreturn]] void refuse(const std::string& expected) {
    throw InputError(SourceLocation{std::string(commandPlace)}, "expected " + expected);
}

void requireCount(const Words& words, std::size_t least, std::size_t most, const char* expected) {
    if (words.size() < least || words.size() > most) refuse(expected);
}

double number(const std::string& text) {
    double value = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        refuse(fmt::format("a number, found {}", inQuotes(text)));
    return value;
}

std::uint32_t count(const std::string& text) {
    const double value = number(text);
    if (value < 0 || value > 65535 || value != std::floor(value))
        refuse(fmt::format("a whole number from 0 to 65535, found {}", inQuotes(text)));
    return static_cast<std::uint32_t>(value);
}

std::string given(const Words& words, std::size_t index, const char* otherwise) {
    return index < words.size() ? words[index] : otherwise;
}

/// Index of a word among names.
template<std::size_t N>
std::uint32_t choice(const std::string& word, const std::array<std::string_view, N>& names) {
    for (std::uint32_t i = 0; i < N; ++i)
        if (names[i] == word) return i;
    throw InputError(SourceLocation{std::string(commandPlace)},
                     fmt::format("there is no {}{}", inQuotes(word),
                                 suggestion(word, std::span<const std::string_view>(names))));
}

template<class Change>
void look(Viewer& viewer, Change change) {
    PictureChoice choice = viewer.bench().choice();
    change(choice);
    viewer.bench().look(choice);
}

// Camera and time.

void orbit(Viewer& viewer, const Words& words) {
    requireCount(words, 2, 2, "orbit X Y, in heights of the picture");
    const double x = number(words[0]);
    const double y = number(words[1]);
    viewer.bench().moveCamera().orbit(x, y);
}
void pan(Viewer& viewer, const Words& words) {
    requireCount(words, 2, 2, "pan X Y, in heights of the picture");
    const double x = number(words[0]);
    const double y = number(words[1]);
    viewer.bench().moveCamera().pan(x, y);
}
void zoom(Viewer& viewer, const Words& words) {
    requireCount(words, 1, 1, "zoom STEPS");
    const double steps = number(words[0]);
    viewer.bench().moveCamera().approach(steps);
}
void frame(Viewer& viewer, const Words&) {
    viewer.bench().frameObject();
}
void home(Viewer& viewer, const Words&) {
    viewer.bench().resetCamera();
}
void play(Viewer& viewer, const Words&) {
    viewer.bench().play(!viewer.bench().isPlaying());
}
void step(Viewer& viewer, const Words&) {
    viewer.bench().step();
}

// The graph.

void set(Viewer& viewer, const Words& words) {
    requireCount(words, 1, 1, "set NODE.PARAM=JSON or PARAM=JSON");
    const std::size_t equals = words[0].find('=');
    if (equals == std::string::npos || equals == 0) refuse("set NODE.PARAM=JSON or PARAM=JSON");
    const std::size_t end = words[0].find_last_not_of(blanks, equals - 1);
    viewer.bench().set(words[0].substr(0, end == std::string::npos ? 0 : end + 1),
                       words[0].substr(equals + 1), document::Gesture::Starts);
}
void reset(Viewer& viewer, const Words& words) {
    requireCount(words, 1, 1, "reset NODE.PARAM or PARAM");
    viewer.bench().reset(words[0]);
}
void node(Viewer& viewer, const Words& words) {
    requireCount(words, 2, 2, "node NAME on|off");
    constexpr std::array<std::string_view, 2> states{"off", "on"};
    viewer.bench().switchNode(words[0], choice(words[1], states) == 1);
}
void swap(Viewer& viewer, const Words& words) {
    requireCount(words, 2, 2, "swap NODE PASS");
    viewer.bench().swapPass(words[0], words[1]);
}
void undo(Viewer& viewer, const Words&) {
    viewer.bench().undo();
}
void redo(Viewer& viewer, const Words&) {
    viewer.bench().redo();
}
void save(Viewer& viewer, const Words&) {
    viewer.bench().save();
    viewer.state().message = fmt::format("saved {}", viewer.bench().document().file().string());
}

// What is looked at.

void show(Viewer& viewer, const Words& words) {
    if (words.empty()) refuse("show NODE.PORT");
    const std::string name = fmt::format("{}", fmt::join(words, " "));
    Diagnostics diagnostics;
    const auto port = graph::readPortReference(name, {std::string(commandPlace)}, diagnostics);
    diagnostics.throwIfErrors();
    viewer.bench().document().graph()->find(*port);  // throws where there is none
    look(viewer, [&](PictureChoice& choice) { choice.port = name; });
}
void level(Viewer& viewer, const Words& words) {
    requireCount(words, 1, 1, "level N");
    look(viewer, [&](PictureChoice& choice) { choice.level = count(words[0]); });
}
void layer(Viewer& viewer, const Words& words) {
    requireCount(words, 1, 1, "layer N");
    look(viewer, [&](PictureChoice& choice) { choice.layer = count(words[0]); });
}
void channel(Viewer& viewer, const Words& words) {
    requireCount(words, 1, 1, "channel color|r|g|b|a|luminance");
    constexpr std::array<std::string_view, 6> names{"color", "r", "g", "b", "a", "luminance"};
    look(viewer, [&](PictureChoice& chosen) { chosen.channel = choice(words[0], names); });
}
void curve(Viewer& viewer, const Words& words) {
    requireCount(words, 1, 1, "curve clip|neutral|signed");
    constexpr std::array<std::string_view, 3> names{"clip", "neutral", "signed"};
    look(viewer, [&](PictureChoice& chosen) { chosen.curve = choice(words[0], names); });
}
void exposure(Viewer& viewer, const Words& words) {
    requireCount(words, 0, 1, "exposure [FACTOR]");
    if (words.empty()) return viewer.bench().exposeAutomatically();
    const double factor = number(words[0]);
    if (factor < 0 || factor > greatestExposure)
        refuse(fmt::format("a factor from 0 to {:g}, found {}", greatestExposure, inQuotes(words[0])));
    look(viewer, [&](PictureChoice& choice) { choice.exposure = factor; });
}
void reference(Viewer& viewer, const Words& words) {
    requireCount(words, 0, 1, "reference [FILE.exr]");
    const std::string file = given(words, 0, "");
    look(viewer, [&](PictureChoice& choice) {
        choice.reference = file.empty() ? std::filesystem::path() : std::filesystem::absolute(file);
    });
}
void difference(Viewer& viewer, const Words&) {
    look(viewer, [&](PictureChoice& choice) { choice.difference = !choice.difference; });
}
void magnify(Viewer& viewer, const Words& words) {
    requireCount(words, 0, 3, "magnify [FACTOR [X Y]], X and Y from 0 to 1");
    Magnification wanted;
    if (!words.empty()) wanted.factor = std::clamp(number(words[0]), 1.0, 512.0);
    if (words.size() == 2) refuse("magnify [FACTOR [X Y]], X and Y from 0 to 1");
    if (words.size() == 3) wanted.center = {number(words[1]), number(words[2])};
    viewer.state().magnification = wanted;
}
void size(Viewer& viewer, const Words& words) {
    requireCount(words, 2, 2, "size WIDTH HEIGHT");
    const graph::Extent extent{count(words[0]), count(words[1])};
    if (extent.width == 0 || extent.height == 0) refuse("a picture of at least 1 x 1");
    viewer.bench().resize(extent);
}

// Files and the window.

/// The file that a command names, or `usual`. Another ending is refused: it may be the graph's or the scene's
/// name.
std::string pictureFile(Viewer& viewer, const Words& words, const char* usual, std::string_view ending) {
    const std::string file = given(words, 0, usual);
    if (std::filesystem::path(file).extension() != ending)
        refuse(fmt::format("a file's name that ends in {}, found {}", ending, inQuotes(file)));
    if (viewer.bench().reads(file)) refuse(fmt::format("a file that is not read, found {}", inQuotes(file)));
    return file;
}

void screenshot(Viewer& viewer, const Words& words) {
    requireCount(words, 0, 1, "screenshot [FILE.png]");
    const std::string file = pictureFile(viewer, words, "picture.png", ".png");
    viewer.bench().writePng(file);
    viewer.state().message = "wrote " + file;
}
void capture(Viewer& viewer, const Words& words) {
    requireCount(words, 0, 1, "capture [FILE.exr]");
    const std::string file = pictureFile(viewer, words, "picture.exr", ".exr");
    viewer.bench().writeExr(file);
    viewer.state().message = "wrote " + file;
}
void window(Viewer& viewer, const Words& words) {
    requireCount(words, 0, 1, "window [FILE.png]");
    viewer.state().windowCapture = pictureFile(viewer, words, "window.png", ".png");
}
void tab(Viewer& viewer, const Words& words) {
    requireCount(words, 1, 1, "tab timings|skips|graph");
    constexpr std::array<std::string_view, 3> names{"timings", "skips", "graph"};
    viewer.state().wantedTab = static_cast<LowerTab>(choice(words[0], names));
    viewer.state().showsLower = true;
}
void lower(Viewer& viewer, const Words&) {
    viewer.state().showsLower = !viewer.state().showsLower;
}
void command(Viewer& viewer, const Words&) {
    viewer.state().asksForCommand = true;
}
void help(Viewer& viewer, const Words&) {
    viewer.state().showsHelp = !viewer.state().showsHelp;
}
void faults(Viewer& viewer, const Words&) {
    viewer.state().answersWithAllFaults = true;
}
void quit(Viewer& viewer, const Words&) {
    viewer.close();
}

constexpr std::array table{
    Command{"orbit", "X Y", {}, "Turns around the target; 1 is half a turn.", orbit},
    Command{"pan", "X Y", {}, "Moves along the picture; 1 is its height.", pan},
    Command{"zoom", "STEPS", {}, "Goes nearer by a tenth of the distance each step.", zoom},
    Command{"frame", "", {GLFW_KEY_F}, "Fits the objects into the picture.", frame},
    Command{"home", "", {GLFW_KEY_HOME}, "Back to the scene's own camera.", home},
    Command{"play", "", {GLFW_KEY_SPACE}, "Lets time run, or stops it.", play},
    Command{"step", "", {'.'}, "A thirtieth of a second on.", step},
    Command{"set", "NODE.PARAM=JSON", {}, "Sets a parameter of a node, or PARAM of the graph.", set},
    Command{"reset", "NODE.PARAM", {}, "Gives a parameter its manifest's value.", reset},
    Command{"node", "NAME on|off", {}, "Switches a node on or off.", node},
    Command{"swap", "NODE PASS", {}, "Gives a node another pass.", swap},
    Command{"undo", "", {'Z', true}, "Takes the last edit back.", undo},
    Command{"redo", "", {'Z', true, true}, "Makes it again.", redo},
    Command{"save", "", {'S', true}, "Writes the graph's file: only what changed changes in it.", save},
    Command{"show", "NODE.PORT", {}, "Looks at a port; also mip(...), layer(...), previous(...).", show},
    Command{"level", "N", {}, "Looks at that mip level.", level},
    Command{"layer", "N", {}, "Looks at that array layer.", layer},
    Command{"channel", "color|r|g|b|a|luminance", {}, "Looks at that channel.", channel},
    Command{"curve", "clip|neutral|signed", {}, "How values become brightness.", curve},
    Command{"exposure", "[FACTOR]", {'E'}, "Factor before the curve; without one it is found.", exposure},
    Command{
        "reference", "[FILE.exr]", {}, "Puts a reference beside the picture, or takes it away.", reference},
    Command{"difference", "", {'D'}, "Shows the distance from the reference, or no longer.", difference},
    Command{"magnify", "[FACTOR [X Y]]", {'0'}, "Magnifies around a place of the picture, 0 to 1.", magnify},
    Command{"size", "WIDTH HEIGHT", {}, "Renders with so many pixels.", size},
    Command{"screenshot", "[FILE.png]", {GLFW_KEY_F2}, "Writes the picture as it is seen.", screenshot},
    Command{"capture", "[FILE.exr]", {GLFW_KEY_F3}, "Writes the true values of what is looked at.", capture},
    Command{"window", "[FILE.png]", {}, "Writes the whole window.", window},
    Command{"tab", "timings|skips|graph", {}, "Opens a tab below the picture.", tab},
    Command{"lower", "", {GLFW_KEY_TAB}, "Hides or shows what is below the picture.", lower},
    Command{"command", "", {'P', true}, "Opens the command line.", command},
    Command{"help", "", {GLFW_KEY_F1}, "Shows or hides this list.", help},
    Command{"faults", "", {}, "Answers with all that is wrong, in files too.", faults},
    Command{"quit", "", {'Q', true}, "Closes the window; a second time also with unsaved edits.", quit},
};

}  // namespace

std::span<const Command> allCommands() {
    return table;
}

}  // namespace nephrite::view
