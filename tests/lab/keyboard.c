/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "lab/keyboard.h"

#include <fcntl.h>
#include <unistd.h>

#include <curses.h>

bool keyboard_open(Keyboard *keyboard, const char *term)
{
    const char *stand_in;
    *keyboard = (Keyboard){.time = 1};
    if (pipe(keyboard->ends) != 0 || fcntl(keyboard->ends[0], F_SETFL, O_NONBLOCK) != 0 ||
        !grid_open(&keyboard->grid, term, keyboard->ends[0], true, &stand_in, NULL))
        return false;
    keys_define(keyboard->grid.keys);
    set_escdelay(0); /* what belongs to an Esc is in the pipe with it */
    grid_enter(&keyboard->grid);
    return stand_in == NULL;
}

void keyboard_close(Keyboard *keyboard)
{
    grid_close(&keyboard->grid);
    close(keyboard->ends[0]);
    close(keyboard->ends[1]);
}

bool keyboard_type(const Keyboard *keyboard, const void *bytes, size_t count)
{
    return write(keyboard->ends[1], bytes, count) == (ssize_t)count;
}

bool keyboard_next(Keyboard *keyboard, Key *key)
{
    return keys_read(&keyboard->reader, keyboard->grid.keys, keyboard->time, key);
}
