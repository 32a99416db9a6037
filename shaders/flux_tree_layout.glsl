// Where the nodes of a flux tree lie: a square of base x base leaves, base a power of two, halved level by level up to one
// node. Level after level, the leaves first, lie in one image of width base; within a level nodes follow Morton's order, so
// that the four parts of a node are neighbours.
#ifndef FLUX_TREE_LAYOUT_GLSL
#define FLUX_TREE_LAYOUT_GLSL

/// Leaves along an edge of the tree that an image of this size holds: the largest power of two that its width allows.
int treeBase(ivec2 size) {
    return 1 << findMSB(size.x);
}

/// Level of the root; that of the leaves is 0.
int rootLevel(int base) {
    return findMSB(base);
}

/// Nodes below a level.
int nodesBelow(int level, int base) {
    int leaves = 4 * base * base;
    return (leaves - (leaves >> (2 * level))) / 3;
}

/// Every second bit of x, 16 of them, side by side.
int gatheredBits(int x) {
    x &= 0x55555555;
    x = (x | (x >> 1)) & 0x33333333;
    x = (x | (x >> 2)) & 0x0f0f0f0f;
    x = (x | (x >> 4)) & 0x00ff00ff;
    return (x | (x >> 8)) & 0x0000ffff;
}

/// Column and row of a node from its place in its level (Morton 1966).
ivec2 cellOfMorton(int morton) {
    return ivec2(gatheredBits(morton), gatheredBits(morton >> 1));
}

/// The texel that holds a node.
ivec2 nodeTexel(int level, int morton, int base) {
    int node = nodesBelow(level, base) + morton;
    return ivec2(node & (base - 1), node >> rootLevel(base));
}

#endif
