// See graph_document.h: the list of versions to undo and redo, and the file on disk.
#include <fmt/format.h>

#include "document/graph_document.h"
#include "document/rebase.h"
#include "image/output_file.h"

namespace nephrite::document {
namespace {

/// More than anybody undoes; bounds what a long session keeps.
constexpr std::size_t mostVersions = 100;

}  // namespace

void GraphDocument::edit(json::Value next, std::string label, std::string gesture) {
    if (next.document().text == text()) return;
    graph_ = link(next);
    root_ = std::move(next);
    const Version& last = versions_[current_];
    const bool continues =
        current_ > 0 && current_ + 1 == versions_.size() && !gesture.empty() && gesture == last.gesture;
    versions_.resize(current_ + (continues ? 0 : 1));
    versions_.push_back({text(), std::move(label), std::move(gesture)});
    if (versions_.size() > mostVersions) versions_.erase(versions_.begin());
    versions_.front().label.clear();
    current_ = versions_.size() - 1;
}

void GraphDocument::goTo(std::size_t version) {
    json::Value root = json::parse(versions_[version].text, file_.string());
    graph_ = link(root);
    root_ = std::move(root);
    current_ = version;
    versions_[current_].gesture.clear();
}

std::string GraphDocument::undoLabel() const {
    return versions_[current_].label;
}

std::string GraphDocument::redoLabel() const {
    return current_ + 1 < versions_.size() ? versions_[current_ + 1].label : std::string();
}

void GraphDocument::undo() {
    if (current_ > 0) goTo(current_ - 1);
}

void GraphDocument::redo() {
    if (current_ + 1 < versions_.size()) goTo(current_ + 1);
}

Rebase GraphDocument::reload() {
    const json::Value theirs = json::parseFile(file_);
    if (theirs.document().text == savedText()) return {};
    link(theirs);
    Rebased now = rebased(saved_, root_, theirs, [this](const json::Value& root) { link(root); });
    auto graph = link(now.root);
    rebaseVersions(theirs);
    graph_ = std::move(graph);
    root_ = std::move(now.root);
    noteSaved(theirs);
    return std::move(now.report);
}

void GraphDocument::noteSaved(const json::Value& saved) {
    savedParameters_ = graph::readGraph(saved).parameters;
    saved_ = saved;
}

void GraphDocument::rebaseVersions(const json::Value& theirs) {
    std::vector<Version> kept;
    std::size_t current = 0;
    for (std::size_t i = 0; i < versions_.size(); ++i) {
        const json::Value mine = json::parse(versions_[i].text, file_.string());
        const Rebased moved = rebased(saved_, mine, theirs, [this](const json::Value& root) { link(root); });
        const std::string& movedText = moved.root.document().text;
        const bool isNew = kept.empty() || kept.back().text != movedText;
        if (isNew) kept.push_back({movedText, versions_[i].label, {}});
        if (i == current_) current = kept.size() - 1;
    }
    kept.front().label.clear();
    versions_ = std::move(kept);
    current_ = current;
}

Rebase GraphDocument::save() {
    std::error_code ignored;
    const bool isThere = std::filesystem::exists(file_, ignored);
    Rebase report = isThere ? reload() : Rebase{};
    if (isThere && !isModified()) return report;
    image::writeFile(file_, text());
    noteSaved(root_);
    return report;
}

}  // namespace nephrite::document
