/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Particles as XML point data for ParaView: one .vtu file for each frame, and a .pvd file that names them
 * with their times. Points stand at their reference positions; "displacement" and "velocity" are vectors. */
#ifndef EXPORT_VTK_H
#define EXPORT_VTK_H

#include "methods/method.h"

#include <stdio.h>

/* The name of frame `i` of `count` for what the user wrote ("beam", "beam.vtu", "beam.pvd"); free() it. With
 * one frame there is "beam.vtu" alone. */
char *vtk_frame_name(const char *name, size_t i, size_t count);
char *vtk_collection_name(const char *name);

/* How the numbers of a frame are written: as text, or behind the XML as they are in memory (raw appended data
 * of 64 bits), which is a third of the size and read much faster. */
typedef enum VtkData { VTK_TEXT, VTK_RAW } VtkData;

/* False: not enough memory. */
bool vtk_write_frame(FILE *, const Simulation *, VtkData);

void vtk_begin_collection(FILE *);
void vtk_add_to_collection(FILE *, const char *frame_name, double time);
void vtk_end_collection(FILE *);

#endif
