// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

/// What is drawn from the finished picture's depth, normals and names, instance by instance. All
/// of it changes the colours of the instance that asks for it and no others'. Translucent instances
/// have no depth and no names in the picture, and so none of this; what lies behind them has, and
/// shows through them with its lines (with Background::kKeepApart these are drawn over them).
namespace limn {

/// How an edge between two pixels next to each other is found.
enum class OutlineDetector : std::uint8_t {
  kNone,
  /// The planes through what two pixels show predict each other: there is a step where one lies off
  /// the other's plane by more than the tolerance, and not behind both, as on a rounded border
  /// (after Saito and Takahashi 1990). Never on a plane, however it is tilted.
  kPlane,
  /// The slope of the distance along the gaze by Sobel's operator (the chapter's convolution) on
  /// the way from one pixel to the other, at both: also on planes tilted by more than the
  /// tolerance.
  kSobel,
  /// A change of sign of the Laplacian of that distance.
  kLaplacian,
};

/// How a crease between two pixels next to each other is found in the normals, by an angle theta.
enum class CreaseDetector : std::uint8_t {
  kAngle,  ///< they are more than theta apart: exact for sharp creases, and nowhere else
  /// Sobel's gradient of the normals, at one of the two, is longer than that of a sharp crease by
  /// theta, which is half the chord 2 sin(theta/2), and more than a third of the chord lies between
  /// the two: bevels within two pixels count as creases, too.
  kSobel,
  /// The Laplacian of the normals turns over: those at the two pixels have a negative product, and
  /// differ by more than at a sharp crease along a row or a column of pixels, by two chords.
  kLaplacian,
};

inline constexpr float kMaxImageOutlineWidth = 64;  ///< pixels

/// Lines along borders to other instances and to the background, along steps and along creases.
/// Steps and borders belong to the nearer surface: the line lies inside of it,
/// `Style::outlineWidth` wide from the border, which is found in the coverage of the samples to a
/// part of a pixel. Creases lie in the middle of their line, and so do borders along which two
/// instances cut each other, each drawing what is on its side: more of it, up to all, where it
/// comes to its outline, and if only one has lines all of it, unless less than a quarter would be
/// on its side. Antialiased by the share of the pixel that the line covers. A line is drawn in the
/// pixels of its surface: those from which a straight way to it crosses no step by kPlane and no
/// other instance; and in pixels that a surface shares with another one's border as if it filled
/// them, as far as it does. Where a border goes behind another surface, its line goes straight
/// on, for as many pixels as it is wide and two more. What lies next to the frame is looked at,
/// too, so that the lines are those of a larger picture; what the frame has held before is taken to
/// go on as at its border.
struct ImageOutline {
  /// How far outside of the frame, in pixels beyond the line's width: two as above, and four to
  /// tell how near a cut is to an outline.
  static constexpr int kApron = 6;
  /// Steps in fewer pixels that touch each other are specks, and left out; but for those that touch
  /// a border. Where normals differ they count as creases, so that a crease's line is one though
  /// here and there it is a step; where they do not, those that touch a crease are kept.
  static constexpr unsigned kSmallestStep = 8;
  /// Creases that cross fewer ways from a pixel to the next, one after the other, are left out; but
  /// for those that touch a border, also between ids, a step's line or the end of what is looked
  /// at.
  static constexpr unsigned kShortestCrease = 8;
  /// Where two instances cut each other the line goes over to the side of the one that comes to its
  /// outline, and to that of a steep one, of which nobody can tell how far that is: from here on,
  /// the square of one over its normal's cosine to the gaze, that of 12 pixels in depth for one
  /// aside.
  static constexpr float kSteepestCut = 145;
  /// Where two surfaces meet in a groove there is no step, though a steep one leaves the other's
  /// plane by more than depthTolerance within a pixel. Where one ends before another their planes
  /// may meet between two pixels, too, but then the steeper one bends: it is a groove if the
  /// steeper's normals differ, to the next pixel away from the other, by no more than one degree:
  /// 1 - n.n' of that.
  static constexpr float kFlat = 1.5e-4f;
  /// Samples of one pixel show two sides of a groove if each is before the other's plane, by no
  /// more than so many tolerances of a step.
  static constexpr float kGroove = 4;

  /// Rounding of 1 - n.n', below which normals are the same whatever creaseDegrees, that is up to
  /// 0.08 degrees. What it does to directions counts by its square; a unit vector's length is right
  /// to 3.5 roundings (half of the three of its square, and one each of the root and the quotient),
  /// and the product adds three: ten in all, 2^-24 each, and as much again to spare.
  static constexpr float kSameNormals = 1.2e-6f;

  OutlineDetector detector = OutlineDetector::kNone;
  float depthTolerance = 3;  ///< of a step, in pixels' widths where it is; >= 0
  /// Normals that differ by more, and more than kSameNormals, make a line; 0 to 180, 180: none.
  float creaseDegrees = 40;
  CreaseDetector creases = CreaseDetector::kAngle;
  /// Borders between Attributes::cellIds of one instance that are no steps have lines, too, in
  /// their middle as creases have. Where such a border lies within its pixels tell the samples that
  /// show either id: counted across the border they are its height over a pixel's side, and heights
  /// of a straight border are exact (the height functions of volumes of fluid, Hirt and Nichols
  /// 1981).
  bool ids = false;
};

}  // namespace limn
