/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "picture/paper/cairo_calls.h"

#ifdef HAVE_CAIRO

#include <dlfcn.h>
#include <stddef.h>

CairoCalls cairo_calls;

bool cairo_load(Status *status)
{
    static bool loaded;
    void *library = loaded ? NULL : dlopen("libcairo.so.2", RTLD_NOW | RTLD_LOCAL);
    if (!loaded && !library)
        return status_fail(status,
                           "PDF, PNG and GIF need cairo (Debian package libcairo2; an SVG needs nothing): %s",
                           dlerror());
    if (loaded)
        return true;
    loaded = true;
#define CAIRO_FIND(name)                                                                                     \
    loaded = (*(void **)&cairo_calls.name = dlsym(library, "cairo_" #name)) != NULL && loaded;
    CAIRO_CALLS(CAIRO_FIND)
#undef CAIRO_FIND
    return loaded || status_fail(status, "libcairo.so.2 of this machine is too old for figures");
}

#else

bool cairo_load(Status *status)
{
    return status_refuse(
        status, "PDF and PNG need cairo, which this program was built without (an SVG needs nothing; "
                "Debian package libcairo2-dev)");
}

#endif
