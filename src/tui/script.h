/* The laboratory without a terminal: keys from a file, screens to standard output, a clock that only frames
 * and steps move. The same script gives the same screens, always.
 *
 * One instruction a line; empty lines and lines that begin with # are skipped.
 *
 *     key NAME...       presses keys by name (Space, Enter, ^C, ], ...)
 *     type TEXT         presses the characters of the text one by one
 *     click X Y         presses the mouse in a column and a row, from 0
 *     wait SECONDS      lets that much time pass, frame by frame
 *     size WIDTHxHEIGHT resizes the screen
 *     rate STEPS        the engine does that many steps in a second; 0: as many as are asked for
 *     screen [NAME]     prints the screen, under a line with the name
 *     styles [NAME]     prints its styles, one letter a cell
 *     expect TEXT       the text is on the screen, within one line
 *     reject TEXT       it is not
 *     closed            the laboratory has been left
 *
 * The first instruction that misses ends the script: "FILE:LINE: ..." and exit status 1. */
#ifndef TUI_SCRIPT_H
#define TUI_SCRIPT_H

#include "tui/laboratory.h"

int script_run(const LaboratoryOptions *, Status *);

#endif
