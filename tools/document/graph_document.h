// A graph file as it is being edited: the text on disk, the edited text, and the graph that this one links
// to.
//
// Every edit patches the text (text/json_edit.h), is read and linked, and counts only if that succeeds: what
// is refused leaves the document as it was. Nothing here draws or renders.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "graph/linked_graph.h"
#include "text/json_edit.h"

namespace nephrite::document {

/// What became of the edits when the file had changed on disk.
struct Rebase {
    bool fileChanged = false;
    std::vector<std::string> overruled;  ///< `parameters.taps.value`: changed on both sides, the edit stands
    std::vector<std::string> dropped;    ///< edits that no longer fit, each with the reason
};

/// Whether an edit goes on with the one before, as while a slider is dragged: the two are undone together if
/// they set the same parameter.
enum class Gesture : std::uint8_t { Starts, Continues };

class GraphDocument {
  public:
    /// Reads and links the file. Throws InputError.
    GraphDocument(std::filesystem::path file, std::shared_ptr<const graph::PassLibrary> passTypes);

    const std::filesystem::path& file() const { return file_; }
    const json::Value& root() const { return root_; }                  ///< of the edited text
    const std::string& text() const { return root_.document().text; }  ///< as edited
    const std::string& savedText() const {
        return saved_.document().text;
    }  ///< as on disk, as far as is known
    /// The graph's parameters as the file on disk declares them, as far as is known.
    const std::vector<graph::GraphParameter>& savedParameters() const { return savedParameters_; }
    bool isModified() const { return text() != savedText(); }

    /// The graph of the edited text. It keeps its pass types alive; another one with each edit.
    const std::shared_ptr<const graph::LinkedGraph>& graph() const { return graph_; }
    const graph::PassLibrary& passTypes() const { return *passTypes_; }
    /// Links anew with other pass types, when a manifest has changed. Throws InputError; the document then
    /// keeps the ones it had.
    void setPassTypes(std::shared_ptr<const graph::PassLibrary> passTypes);

    // Edits. A `target` is "PARAM", a parameter of the graph, or "NODE.PARAM". Each throws InputError with
    // the reader's faults, and then nothing has changed.

    /// Gives a parameter a value. A node's parameter that is bound to a graph parameter is so no longer, and
    /// becomes so with `json` = "\"$NAME\"".
    void set(const std::string& target, std::string_view json, Gesture gesture = Gesture::Starts);
    /// A node's parameter as its manifest has it: the setting is removed. A graph parameter as the file has
    /// it.
    void reset(const std::string& target);
    /// The parameter as the file on disk has it.
    void revert(const std::string& target);
    /// Whether the edited text and the file on disk give the parameter different values.
    bool differsFromFile(const std::string& target) const;

    /// False where "when" is a constant that is false.
    bool isOn(const std::string& node) const;
    /// Off: "when" becomes false. On: "when" becomes what it was when the node was last on, as far back as
    /// can be undone or as the file has it; else it is removed.
    void switchNode(const std::string& node, bool on);
    /// Another pass type for a node, without the settings and formats that the type does not have or refuses;
    /// returns those (`set.taps`). graph::choicesFor() tells which types fit.
    std::vector<std::string> swapPass(const std::string& node, const std::string& passType);

    /// What undo() would take back ("set dipole.taps"), or nothing.
    std::string undoLabel() const;
    std::string redoLabel() const;
    /// One edit back, or forth; nothing happens without one. Saving and changes on disk keep the list. Throws
    /// InputError if the text no longer links with the pass types of now.
    void undo();
    void redo();

    /// Takes over what has changed in the file: the edits are made again on top of it, value by value, and so
    /// are those that can be undone and redone. Where both changed a value the edit stands. Throws InputError
    /// if the file cannot be read or linked; the document then stays as it was.
    Rebase reload();
    /// Writes the edited text, as a whole or not at all, after reload(). A file that is gone is written anew.
    /// Throws InputError as reload() does, and then nothing is written; RunError if it cannot be written.
    Rebase save();

  private:
    struct Version {
        std::string text;
        std::string label;    ///< of the edit that made it
        std::string gesture;  ///< edits that may go on with it have the same
    };

    std::shared_ptr<const graph::LinkedGraph> link(const json::Value& root) const;
    void edit(json::Value next, std::string label, std::string gesture = {});
    void goTo(std::size_t version);
    json::Value lastWithNodeOn(const std::string& node) const;
    graph::Index indexOf(const std::string& node) const;
    json::Path pathOf(const std::string& target) const;
    void noteSaved(const json::Value& saved);
    void rebaseVersions(const json::Value& theirs);

    std::filesystem::path file_;
    std::shared_ptr<const graph::PassLibrary> passTypes_;
    json::Value saved_;
    std::vector<graph::GraphParameter> savedParameters_;
    json::Value root_;
    std::shared_ptr<const graph::LinkedGraph> graph_;
    std::vector<Version> versions_;  ///< the oldest first
    std::size_t current_ = 0;
};

}  // namespace nephrite::document
