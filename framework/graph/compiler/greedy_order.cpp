// See greedy_order.h.
#include "graph/compiler/greedy_order.h"

#include <algorithm>
#include <queue>

namespace nephrite::graph {
namespace {

class GreedyOrder {
  public:
    explicit GreedyOrder(const GreedyProblem& problem)
        : problem_(problem),
          missing_(problem.before.rows.size()),
          gain_(problem.before.rows.size(), 0),
          usersLeft_(problem.bytes.size()),
          alive_(problem.bytes.size(), 0) {
        for (Index pass = 0; pass < missing_.size(); ++pass) missing_[pass] = problem.before.rows[pass].count;
        for (Index resource = 0; resource < alive_.size(); ++resource) {
            usersLeft_[resource] = problem.users.rows[resource].count;
            if (!problem.aliveFromTheStart.empty()) alive_[resource] = problem.aliveFromTheStart[resource];
        }
    }

    std::vector<Index> order() {
        std::vector<Index> result;
        result.reserve(missing_.size());
        moveWindow();
        while (!ready_.empty()) {
            const Candidate next = ready_.top();
            ready_.pop();
            if (missing_[next.pass] == placed || next.gain != gain_[next.pass]) continue;
            result.push_back(next.pass);
            place(next.pass);
            moveWindow();
        }
        return result;
    }

  private:
    static constexpr Index placed = noIndex;

    struct Candidate {
        std::int64_t gain = 0;    ///< bytes that die less those that come to life
        std::uint32_t since = 0;  ///< of equal ones the latest: it continues what was begun
        Index pass = noIndex;
        bool operator<(const Candidate& other) const {
            return gain != other.gain ? gain < other.gain : since < other.since;
        }
    };

    std::int64_t bytes(Index resource) const { return static_cast<std::int64_t>(problem_.bytes[resource]); }
    bool mayDie(Index resource) const {
        return problem_.aliveToTheEnd.empty() || problem_.aliveToTheEnd[resource] == 0;
    }

    /// The i-th pass in the direction of building.
    Index passAt(Index i) const { return problem_.fromTheEnd ? count() - 1 - i : i; }
    Index count() const { return static_cast<Index>(missing_.size()); }
    bool isInWindow(Index pass) const { return passAt(pass) < windowEnd_; }

    void moveWindow() {
        while (firstLeft_ < count() && missing_[passAt(firstLeft_)] == placed) ++firstLeft_;
        const Index end = firstLeft_ + std::min(problem_.window, count() - firstLeft_);
        while (windowEnd_ < end) {
            const Index pass = passAt(windowEnd_++);
            if (missing_[pass] == 0) makeReady(pass);
        }
    }

    void makeReady(Index pass) {
        std::int64_t gain = 0;
        for (const Index resource : problem_.touched[pass]) {
            if (alive_[resource] == 0) gain -= bytes(resource);
            if (usersLeft_[resource] == 1 && mayDie(resource)) gain += bytes(resource);
        }
        gain_[pass] = gain;
        ready_.push({gain, clock_++, pass});
    }

    /// A resource has come to life or has only one user left: its users gain more than before.
    void raiseUsers(Index resource) {
        for (const Index user : problem_.users[resource]) {
            if (missing_[user] != 0 || !isInWindow(user)) continue;
            gain_[user] += bytes(resource);
            ready_.push({gain_[user], clock_++, user});
        }
    }

    void place(Index pass) {
        missing_[pass] = placed;
        for (const Index resource : problem_.touched[pass]) {
            const bool isNew = alive_[resource] == 0;
            alive_[resource] = 1;
            --usersLeft_[resource];
            if (isNew) raiseUsers(resource);
            if (usersLeft_[resource] == 1 && mayDie(resource)) raiseUsers(resource);
        }
        for (const Index next : problem_.after[pass]) {
            if (--missing_[next] == 0 && isInWindow(next)) makeReady(next);
        }
    }

    const GreedyProblem& problem_;
    std::vector<Index> missing_;       ///< by pass: those before it that are not placed yet
    std::vector<std::int64_t> gain_;   ///< by pass that is ready
    std::vector<Index> usersLeft_;     ///< by resource
    std::vector<std::uint8_t> alive_;  ///< by resource
    std::priority_queue<Candidate> ready_;
    std::uint32_t clock_ = 0;
    Index firstLeft_ = 0;  ///< the first pass that is not placed, counted in the direction of building
    Index windowEnd_ = 0;
};

}  // namespace

std::vector<Index> greedyOrder(const GreedyProblem& problem) {
    return GreedyOrder(problem).order();
}

}  // namespace nephrite::graph
