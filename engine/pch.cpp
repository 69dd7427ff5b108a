// The precompiled headers that every floor reuses are built once, with this file.
