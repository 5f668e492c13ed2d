"""Python interface of the crowd simulator; messages and services are in social_crowd.msg and social_crowd.srv."""
