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
    .sentences = {translatable("ErrorText", "voxels of %1 mm would take %2 MB, and %3 MB are left")},
    .advice = {translatable("ErrorText", "Choose larger voxels, or close other programs.")}};

const ErrorDescription VolumeErrors::TooLargeToSave{
    .id = "TooLargeToSave",
    .sentences = {translatable("ErrorText", "voxels of %1 mm make a volume of %2 MB, and a document holds %3 MB")},
    .advice = {translatable("ErrorText", "Choose larger voxels, or work on a piece of the part.")}};

const ErrorDescription VolumeErrors::NoVoxelInside{
    .id = "NoVoxelInside",
    .sentences = {translatable("ErrorText", "no voxel of %1 mm lies inside: the part is thinner than they are")},
    .advice = {translatable("ErrorText", "Choose smaller voxels.")}};

const ErrorDescription VolumeErrors::NothingInside{
    .id = "NothingInside",
    .sentences = {translatable("ErrorText", "the surface encloses nothing")},
    .advice = {translatable("ErrorText",
                            "Turn its faces outwards, or make walls of sheets: 'handwheel voxelize --wall MM'.")}};

const ErrorDescription VolumeErrors::NoSuchDrill{
    .id = "NoSuchDrill",
    .sentences = {translatable("ErrorText", "there is no drill “%1”")},
    .advice = {
        translatable("ErrorText", "Write ball, burr or twist with a diameter from 0.05 to 200 mm, such as ball:6.")}};

const ErrorDescription VolumeErrors::NoSuchDrillMaterial{
    .id = "NoSuchDrillMaterial",
    .sentences = {translatable("ErrorText", "there is no material “%1” to be drilled")},
    .advice = {translatable("ErrorText", "'handwheel help drill' lists the materials.")}};

const ErrorDescription VolumeErrors::PathTooLong{
    .id = "PathTooLong",
    .sentences = {translatable("ErrorText", "the path takes %1 s, and %2 s can be drilled at this rate")},
    .advice = {translatable("ErrorText", "Choose fewer cycles a second, or a part of the path.")}};

const ErrorDescription VolumeErrors::NothingInRange{
    .id = "NothingInRange",
    .sentences = {translatable("ErrorText", "nothing has a value from %1 to %2: those of the image go from %3 to %4")},
    .advice = {translatable("ErrorText", "Choose another range; bone in a CT begins at about 300.")}};

}  // namespace handwheel
