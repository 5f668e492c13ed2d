"""A client of dynamic_reconfigure for a node of a test."""
import dynamic_reconfigure.client
import support


class Reconfigurer:
    """The standard client, with the updates that it has received."""

    def __init__(self, node):
        self.updates = []
        self.client = dynamic_reconfigure.client.Client(node, timeout=support.PATIENCE,
                                                        config_callback=self.updates.append)

    def set(self, **changes):
        """Requests changes. Returns the values in the response."""
        return values_of(self.client.update_configuration(changes))

    def descriptions(self):
        """Returns the descriptions of the parameters by name."""
        return {about['name']: about for about in self.client.get_parameter_descriptions(support.PATIENCE)}

    def wait(self, **expected):
        """Waits until the newest update has these values."""
        support.wait_for(lambda: self.updates and expected.items() <= values_of(self.updates[-1]).items(),
                         f'an update with {expected}')

    def close(self):
        """Closes the connections."""
        self.client.close()


def values_of(configuration):
    """Returns the values of a configuration without its groups."""
    return {name: value for name, value in configuration.items() if name != 'groups'}
