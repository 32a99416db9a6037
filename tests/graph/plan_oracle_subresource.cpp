// See plan_oracle_subresource.h.
#include "graph/plan_oracle_subresource.h"

#include <bit>

namespace nephrite::graph::tests {
namespace {

/// Calls `visit` with the number of each set bit.
template<class Visit>
void forEachUse(Uses uses, Visit visit) {
    for (; uses != 0; uses &= uses - 1) visit(static_cast<std::size_t>(std::countr_zero(uses)));
}

}  // namespace

Uses SubresourceState::happened() const {
    Uses result = writers | (writers != 0 ? writersOrdered : 0) | readers;
    forEachUse(readers, [&](std::size_t use) { result |= readersOrdered[use]; });
    return result;
}

bool SubresourceState::writersReached(Uses usesBefore) const {
    return (writers & ~usesBefore) == 0 || (writersOrdered & usesBefore) != 0;
}

bool SubresourceState::allReached(Uses usesBefore) const {
    bool all = writers == 0 || writersReached(usesBefore);
    forEachUse(readers,
               [&](std::size_t use) { all &= (((Uses{1} << use) | readersOrdered[use]) & usesBefore) != 0; });
    return all;
}

bool SubresourceState::availableAfter(Uses usesBefore, bool makesAvailable) const {
    return writers == 0 || isAvailable || (makesAvailable && (writers & ~usesBefore) == 0);
}

bool SubresourceState::order(Uses usesBefore, Uses usesAfter, bool makesAvailable) {
    bool ordersSomething = false;
    if (writers != 0 && writersReached(usesBefore)) {
        ordersSomething |= (usesAfter & ~writersOrdered) != 0;
        writersOrdered |= usesAfter;
        isAvailable = availableAfter(usesBefore, makesAvailable);
        if (isAvailable) {
            ordersSomething |= (usesAfter & ~visibleTo) != 0;
            visibleTo |= usesAfter;
        }
    }
    forEachUse(readers, [&](std::size_t use) {
        if ((((Uses{1} << use) | readersOrdered[use]) & usesBefore) == 0) return;
        ordersSomething |= (usesAfter & ~readersOrdered[use]) != 0;
        readersOrdered[use] = static_cast<std::uint16_t>(readersOrdered[use] | usesAfter);
    });
    return ordersSomething;
}

void SubresourceState::settle(Uses usesAfter) {
    writers = maskOf(Use::None);
    writersOrdered = usesAfter;
    visibleTo = usesAfter;
    isAvailable = true;
    readers = 0;
}

bool SubresourceState::writeIsSafe(Use use) const {
    const Uses mask = maskOf(use);
    bool isSafe = writers == 0 || ((writersOrdered & mask) != 0 && (visibleTo & mask) != 0);
    forEachUse(readers, [&](std::size_t reader) { isSafe &= (readersOrdered[reader] & mask) != 0; });
    return isSafe;
}

void SubresourceState::read(Use use) {
    readers |= maskOf(use);
    readersOrdered[static_cast<std::size_t>(use)] = 0;
}

void SubresourceState::write(Use use) {
    writers = maskOf(use);
    writersOrdered = 0;
    visibleTo = 0;
    isAvailable = false;
    readers = 0;
}

}  // namespace nephrite::graph::tests
