// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

// The error codes of volumes.
namespace handwheel::VolumeErrors {

extern const ErrorDescription TooFine;              // {voxel in mm, extent in mm, least voxel in mm}
extern const ErrorDescription TooLarge;             // {voxel in mm, MB that it takes, MB that are available}
extern const ErrorDescription NeedsConsent;         // {voxel in mm, MB that it takes, MB that are available}
extern const ErrorDescription TooLargeToSave;       // {voxel in mm, MB that it takes, MB that a document can hold}
extern const ErrorDescription ImageTooLarge;        // {MB of the image, MB of the volume, MB that a document can hold}
extern const ErrorDescription NoVoxelInside;        // {voxel in mm}; the part is thinner than a voxel
extern const ErrorDescription NothingInside;        // the surface encloses nothing: it is flat, or inside out
extern const ErrorDescription SurfaceIsLost;        // {voxel in mm, % of the surface that is kept, % that is required}
extern const ErrorDescription MaterialIsLost;       // {voxel in mm, mm³ that are kept, mm³ that are required}
extern const ErrorDescription NothingLeft;          // the cut or the inward offset removed everything
extern const ErrorDescription WallTooThin;          // {wall in mm, voxel in mm, largest voxel for the wall in mm}
extern const ErrorDescription NoSuchDrill;          // {word}
extern const ErrorDescription NoSuchDrillMaterial;  // {word}
extern const ErrorDescription PathTooLong;          // {seconds, largest number of seconds}
extern const ErrorDescription ClayRadius;           // {radius, voxel, least radius, largest radius, all in mm}
extern const ErrorDescription StrokesTooLong;       // {length in mm, radius of the tool in mm, largest length in mm}
extern const ErrorDescription LayerTakesNone;       // {name of the layer}; the layer is off, or its strength is below 1
extern const ErrorDescription LayerBelow;           // {name of the layer, name of the topmost layer}
extern const ErrorDescription TooManyLayers;        // {largest number of layers}
extern const ErrorDescription ProgramWord;          // {word of a drilling program}
extern const ErrorDescription ProgramLacks;         // {missing word, word that needs it}
extern const ErrorDescription ProgramValue;         // {word, requirement}
extern const ErrorDescription ProgramTooLong;       // {largest number of moves}
extern const ErrorDescription ProgramMovesNothing;  // the drilling program contains no move
extern const ErrorDescription PictureUnreadable;    // {format of the stamp's file}
extern const ErrorDescription NothingStandsOut;     // the stamp is black, or has the same height everywhere
extern const ErrorDescription FolderWithoutSeries;  // the folder has no series of images
extern const ErrorDescription NothingInRange;  // {least, largest, least value of the image, largest value of the image}

}  // namespace handwheel::VolumeErrors
