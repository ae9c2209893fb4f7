// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/image/ImageFile.h"

namespace handwheel {

// Reads an image in NIfTI-1 (nifti.nimh.nih.gov/nifti-1, nifti1.h). A file is .nii, plain or packed by gzip, of either
// byte order. The grid is that of the sform if there is one, else of the qform, else the spacings; it is converted from
// the coordinates of NIfTI (x to the right, y to the front) to those of ImageGrid. Values are scaled by scl_slope and
// scl_inter. The first image of a time series is read. Errors: HeaderMalformed, ElementMalformed {field, what is
// wrong}, Unsupported (pairs of .hdr and .img, colours, complex numbers), those of imageOfBytes() and inflated().
Result<ImageFile> readNifti(std::string_view bytes);

// Returns true if the first bytes, unpacked if necessary, are those of such a file.
bool looksLikeNifti(std::string_view bytes);

}  // namespace handwheel
