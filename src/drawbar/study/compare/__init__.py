"""A model beside a measurement."""
