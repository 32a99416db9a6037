// Where texels lie in the window.
#include "view/picture_placement.h"

#include <gtest/gtest.h>

#include <array>
#include <utility>

#include "view/layout.h"

namespace nephrite::view {
namespace {

constexpr Area area{300, 40, 400, 500};

TEST(PicturePlacement, AFittedPictureIsWholeAndInTheMiddle) {
    const PicturePlacement placement(area, 200, 100);
    const auto blit = placement.blit(1000, 800);
    ASSERT_TRUE(blit);
    EXPECT_EQ(blit->source, (std::array<std::int32_t, 4>{0, 0, 200, 100}));
    EXPECT_EQ(blit->destination, (std::array<std::int32_t, 4>{300, 190, 700, 390}));
}

TEST(PicturePlacement, TheTexelUnderAPointIsTheOneDrawnThere) {
    PicturePlacement placement(area, 200, 100);
    placement.magnify(7.3, {0.31, 0.77});
    const auto blit = placement.blit(1000, 800);
    ASSERT_TRUE(blit);
    for (double y = 41.5; y < 540; y += 37) {
        for (double x = 301.5; x < 700; x += 29) {
            const auto texel = placement.texelAt({x, y});
            const double column = (x - blit->destination[0]) / (blit->destination[2] - blit->destination[0]);
            const double expected = blit->source[0] + column * (blit->source[2] - blit->source[0]);
            if (!texel) continue;
            EXPECT_NEAR(texel->x + 0.5, expected, 0.6);  // both edges are rounded to pixels
        }
    }
}

TEST(PicturePlacement, NoTexelOutsideThePictureOrTheArea) {
    const PicturePlacement placement(area, 200, 100);
    EXPECT_TRUE(placement.texelAt({500, 290}));
    EXPECT_FALSE(placement.texelAt({500, 100}));  // above the picture
    EXPECT_FALSE(placement.texelAt({299, 290}));
    EXPECT_FALSE(PicturePlacement(area, 0, 0).texelAt({500, 290}));
}

TEST(PicturePlacement, WhatIsDrawnStaysInTheWindow) {
    for (double factor = 1; factor <= 512; factor *= 1.7) {
        for (double center = 0; center <= 1; center += 0.125) {
            PicturePlacement placement({0, 0, 400, 500}, 200, 100);
            placement.magnify(factor, {center, 1 - center});
            const auto blit = placement.blit(400, 500);
            if (!blit) continue;
            EXPECT_GE(blit->destination[0], 0);
            EXPECT_GE(blit->destination[1], 0);
            EXPECT_LE(blit->destination[2], 400);
            EXPECT_LE(blit->destination[3], 500);
            EXPECT_GE(blit->source[0], 0);
            EXPECT_LE(blit->source[2], 200);
        }
    }
}

TEST(PicturePlacement, TheWheelKeepsWhatIsUnderTheMouse) {
    const PicturePlacement before(area, 200, 100);
    const Point mouse{450, 250};
    const Point place = before.toPicture(mouse);
    const Magnification magnified = magnifiedAt(before, {}, mouse, 3);
    PicturePlacement after(area, 200, 100);
    after.magnify(magnified.factor, magnified.center);
    EXPECT_NEAR(after.toPicture(mouse).x, place.x, 1e-9);
    EXPECT_NEAR(after.toPicture(mouse).y, place.y, 1e-9);
    EXPECT_NEAR(after.scale() / before.scale(), 1.25 * 1.25 * 1.25, 1e-12);
}

TEST(PicturePlacement, DraggingTakesThePictureAlong) {
    PicturePlacement before(area, 200, 100);
    const Magnification start{8, {0.5, 0.5}};
    before.magnify(start.factor, start.center);
    const Magnification moved = dragged(before, start, 30, -20);
    PicturePlacement after(area, 200, 100);
    after.magnify(moved.factor, moved.center);
    const Point place = before.toPicture({400, 300});
    EXPECT_NEAR(after.toWindow(place).x, 430, 1e-9);
    EXPECT_NEAR(after.toWindow(place).y, 280, 1e-9);
}

TEST(PicturePlacement, TurnedBackTheWheelFitsThePictureAgain) {
    const PicturePlacement placement(area, 200, 100);
    const Magnification back = magnifiedAt(placement, {1.2, {0.1, 0.9}}, {450, 250}, -5);
    EXPECT_EQ(back.factor, 1);
    EXPECT_EQ(back.center.x, 0.5);
}

bool overlap(const Area& a, const Area& b) {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

TEST(Layout, PartsTouchButDoNotOverlap) {
    for (const auto& [width, height] : {std::pair{640.0, 480.0}, {1024.0, 768.0}, {2560.0, 1440.0}}) {
        for (const LowerPart lower : {LowerPart::Hidden, LowerPart::Low, LowerPart::High}) {
            for (const double scale : {1.0, 2.0}) {
                const Layout layout = layOut(width, height, 30 * scale, scale, lower);
                const std::array parts{layout.bar, layout.controls, layout.picture, layout.inspector,
                                       layout.timings};
                double covered = 0;
                for (std::size_t i = 0; i < parts.size(); ++i) {
                    covered += parts[i].width * parts[i].height;
                    for (std::size_t j = 0; j < i; ++j)
                        EXPECT_FALSE(overlap(parts[i], parts[j])) << i << " " << j;
                }
                EXPECT_NEAR(covered, width * height, 1e-6);
                EXPECT_GE(layout.picture.width, 0.39 * width);
                EXPECT_GE(layout.picture.height, 0.39 * (height - layout.bar.height));
            }
        }
    }
}

}  // namespace
}  // namespace nephrite::view
