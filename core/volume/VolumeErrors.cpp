// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeErrors.h"

namespace handwheel {

const ErrorDescription VolumeErrors::TooFine{
    .id = "TooFine",
    .sentences = {translatable("ErrorText", "voxels of %1 mm are too fine for a part of %2 mm")},
    .advice = {translatable("ErrorText", "Choose voxels of at least %3 mm.")}};

const ErrorDescription VolumeErrors::TooLarge{
    .id = "TooLarge",
    .sentences = {translatable("ErrorText", "voxels of %1 mm would need %2 MB, and %3 MB are available")},
    .advice = {translatable("ErrorText", "Choose larger voxels, or close other programs.")}};

const ErrorDescription VolumeErrors::NeedsConsent{
    .id = "NeedsConsent",
    .sentences = {translatable(
        "ErrorText", "voxels of %1 mm would need %2 MB, which is more than a quarter of the %3 MB that are available")},
    .advice = {translatable("ErrorText", "Choose larger voxels, or confirm it with --yes.")}};

const ErrorDescription VolumeErrors::TooLargeToSave{
    .id = "TooLargeToSave",
    .sentences = {translatable("ErrorText",
                               "voxels of %1 mm make a volume of %2 MB, and a document can contain %3 MB")},
    .advice = {translatable("ErrorText", "Choose larger voxels, or work on a piece of the part.")}};

const ErrorDescription VolumeErrors::ImageTooLarge{
    .id = "ImageTooLarge",
    .sentences = {translatable("ErrorText", "an image of %1 MB with %2 MB of voxels is too large: %3 MB is the most")},
    .advice = {translatable("ErrorText", "Choose larger voxels; 'handwheel segment' keeps no image.")}};

const ErrorDescription VolumeErrors::NoVoxelInside{
    .id = "NoVoxelInside",
    .sentences = {translatable("ErrorText", "no voxel of %1 mm lies inside the part, which is thinner than that")},
    .advice = {translatable("ErrorText", "Choose smaller voxels.")}};

const ErrorDescription VolumeErrors::NothingInside{
    .id = "NothingInside",
    .sentences = {translatable("ErrorText", "the surface encloses no volume")},
    .advice = {translatable("ErrorText",
                            "Turn its faces outwards, or make walls of sheets: 'handwheel voxelize --wall MM'.")}};

const ErrorDescription VolumeErrors::SurfaceIsLost{
    .id = "SurfaceIsLost",
    .sentences = {translatable("ErrorText",
                               "voxels of %1 mm would keep %2 % of the surface, and at least %3 % are needed")},
    .advice = {
        translatable("ErrorText", "Walls thinner than a voxel are lost: choose smaller voxels, or a wall thickness.")}};

const ErrorDescription VolumeErrors::MaterialIsLost{
    .id = "MaterialIsLost",
    .sentences = {translatable("ErrorText", "voxels of %1 mm would contain %2 mm³, and at least %3 mm³ are needed")},
    .advice = {translatable("ErrorText", "Walls thinner than a voxel are lost: choose smaller voxels.")}};

const ErrorDescription VolumeErrors::NothingLeft{
    .id = "NothingLeft",
    .sentences = {translatable("ErrorText", "nothing is left of the material")},
    .advice = {translatable("ErrorText", "Check where the bodies are, or choose a smaller distance.")}};

const ErrorDescription VolumeErrors::WallTooThin{
    .id = "WallTooThin",
    .sentences = {translatable("ErrorText", "a wall of %1 mm is thinner than two voxels of %2 mm")},
    .advice = {translatable("ErrorText", "Choose a thicker wall, or voxels of at most %3 mm.")}};

const ErrorDescription VolumeErrors::NoSuchDrill{
    .id = "NoSuchDrill",
    .sentences = {translatable("ErrorText", "there is no drill “%1”")},
    .advice = {translatable("ErrorText",
                            "Write ball, burr, twist or saw with a diameter from 0.05 to 200 mm, such as ball:6.")}};

const ErrorDescription VolumeErrors::NoSuchDrillMaterial{
    .id = "NoSuchDrillMaterial",
    .sentences = {translatable("ErrorText", "there is no material “%1” to be drilled")},
    .advice = {translatable("ErrorText", "'handwheel help drill' lists the materials.")}};

const ErrorDescription VolumeErrors::PathTooLong{
    .id = "PathTooLong",
    .sentences = {translatable("ErrorText", "the path takes %1 s, and at most %2 s can be followed at this rate")},
    .advice = {translatable("ErrorText", "Choose a lower rate, or a part of the path.")}};

const ErrorDescription VolumeErrors::ClayRadius{
    .id = "ClayRadius",
    .sentences = {translatable(
        "ErrorText", "a tool with a radius of %1 mm does not suit voxels of %2 mm: from %3 to %4 mm it does")},
    .advice = {translatable("ErrorText", "Choose another radius, or other voxels.")}};

const ErrorDescription VolumeErrors::StrokesTooLong{
    .id = "StrokesTooLong",
    .sentences = {translatable("ErrorText",
                               "the strokes go %1 mm, and a tool with a radius of %2 mm can be led %3 mm at most")},
    .advice = {translatable("ErrorText", "Check the unit of the places, or divide the strokes.")}};

const ErrorDescription VolumeErrors::LayerTakesNone{
    .id = "LayerTakesNone",
    .sentences = {translatable("ErrorText",
                               "the layer “%1” takes no strokes, as it is off, or its strength is below 1")},
    .advice = {translatable("ErrorText", "Turn it on with a strength of 1, or add a layer above it.")}};

const ErrorDescription VolumeErrors::LayerBelow{
    .id = "LayerBelow",
    .sentences = {translatable("ErrorText", "the layer “%1” takes no strokes, as the layer “%2” is above it")},
    .advice = {translatable("ErrorText", "Merge the layers above it, or name a new layer.")}};

const ErrorDescription VolumeErrors::TooManyLayers{
    .id = "TooManyLayers",
    .sentences = {translatable("ErrorText", "a volume has at most %1 layers")},
    .advice = {translatable("ErrorText", "Merge some of them first.")}};

const ErrorDescription VolumeErrors::ProgramWord{
    .id = "ProgramWord",
    .sentences = {translatable("ErrorText", "“%1” has no meaning for a drilling program here")},
    .advice = {translatable("ErrorText",
                            "Drill by G0, G1, G81, G82, G83, G80, G98, G99 and G4, in millimetres and absolute.")}};

const ErrorDescription VolumeErrors::ProgramLacks{
    .id = "ProgramLacks", .sentences = {translatable("ErrorText", "%1 is missing, which %2 needs")}};

const ErrorDescription VolumeErrors::ProgramValue{
    .id = "ProgramValue", .sentences = {translatable("ErrorText", "%1 has a value that it cannot have (%2)")}};

const ErrorDescription VolumeErrors::ProgramTooLong{
    .id = "ProgramTooLong",
    .sentences = {translatable("ErrorText", "the program has more than %1 moves")},
    .advice = {translatable("ErrorText", "Choose larger pecks, or a part of the program.")}};

const ErrorDescription VolumeErrors::ProgramMovesNothing{
    .id = "ProgramMovesNothing",
    .sentences = {translatable("ErrorText", "the program moves nothing")},
    .advice = {translatable("ErrorText", "It begins with a move of all three axes, such as G0 X0 Y0 Z10.")}};

const ErrorDescription VolumeErrors::PictureUnreadable{
    .id = "PictureUnreadable",
    .sentences = {translatable("ErrorText", "the picture of format %1 is damaged, or not one that can be read")}};

const ErrorDescription VolumeErrors::NothingStandsOut{
    .id = "NothingStandsOut",
    .sentences = {translatable("ErrorText", "nothing stands out in it: all is black, or of one height")},
    .advice = {translatable("ErrorText", "Choose a picture with bright places, or a shape that rises along z.")}};

const ErrorDescription VolumeErrors::FolderWithoutSeries{
    .id = "FolderWithoutSeries",
    .sentences = {translatable("ErrorText", "the folder contains no DICOM files")},
    .advice = {translatable("ErrorText",
                            "Choose a file, or the folder in which the slices are; folders in it are not searched.")}};

const ErrorDescription VolumeErrors::NothingInRange{
    .id = "NothingInRange",
    .sentences = {translatable("ErrorText",
                               "no sample has a value from %1 to %2: the values of the image range from %3 to %4")},
    .advice = {translatable("ErrorText", "Choose another range; bone in a CT begins at about 300.")}};

}  // namespace handwheel
