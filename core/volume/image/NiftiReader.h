// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/image/ImageFile.h"

namespace handwheel {

// Reads an image in NIfTI-1 (nifti.nimh.nih.gov/nifti-1, nifti1.h). A file is .nii, plain or packed by gzip, of either
// byte order. Its place is that of the sform where there is one, else of the qform, else the spacings; turned to those
// of ImageGrid from NIfTI's (x to the right, y to the front). Values are scaled by scl_slope and scl_inter. Of images
// in time the first is read. Errors: HeaderMalformed, ElementMalformed {field, what is wrong}, Unsupported (pairs of
// .hdr and .img, colours, complex numbers), those of imageOfBytes() and inflated().
Result<ImageFile> readNifti(std::string_view bytes);

// Whether the first bytes are those of such a file; of a packed one they are unpacked.
bool looksLikeNifti(std::string_view bytes);

}  // namespace handwheel
